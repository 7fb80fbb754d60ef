#pragma once
/// @file
/// Studios that several tests use. They are compiled once, in the sources beside this file, because each holds a
/// whole renderer.
#include <spanline/frame/ready_made_traits.hpp>

#include "support/ids_picture.hpp"
#include "support/studio.hpp"

namespace spanline::test {

extern template class Studio<FlatTraits<>>;
extern template class Studio<FlatTraits<Rgb565, Depth24<>>>;
extern template class Studio<FlatTraits<Rgb565, Depth24<>, Spanning>>;
extern template class Studio<GouraudTraits<>>;
extern template class Studio<GouraudTraits<Rgb565, Depth24<>>>;
extern template class Studio<LocalLightTraits<>>;
extern template class Studio<SeeThroughTraits<>>;
extern template class Studio<SeeThroughTraits<Rgb565, Depth24<>, Spanning>>;
extern template class Studio<TextureTraits<>>;
extern template class Studio<TextureTraits<Rgb565, Depth24<>>>;
extern template class Studio<TextureTraits<Rgb565, Depth24<>, Spanning>>;
extern template class Studio<TextureTraits<Rgb565, Depth16<>, Counted>>;
extern template class Studio<FoggedTextureTraits<>>;
extern template class Studio<FoggedTextureTraits<Rgb565, Depth24<>, Spanning>>;
extern template class Studio<IdTraits<>>;
extern template class Studio<IdTraits<Depth24<>>>;
extern template class Studio<Ids>;

extern template class Studio<GeneralTraits<>>;
extern template class Studio<GeneralTraits<Rgb565, Depth24<>>>;
extern template class Studio<GeneralTraits<Rgb565, Depth24<>, Spanning>>;
extern template class Studio<GeneralSeeThroughTraits<>>;
extern template class Studio<GeneralSeeThroughTraits<Rgb565, Depth24<>>>;
extern template class Studio<GeneralSeeThroughTraits<Rgb565, Depth24<>, Spanning>>;

}  // namespace spanline::test
