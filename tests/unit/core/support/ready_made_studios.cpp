#include "support/ready_made_studios.hpp"

namespace spanline::test {

template class Studio<FlatTraits<>>;
template class Studio<FlatTraits<Rgb565, Depth24<>>>;
template class Studio<FlatTraits<Rgb565, Depth24<>, Spanning>>;
template class Studio<GouraudTraits<>>;
template class Studio<GouraudTraits<Rgb565, Depth24<>>>;
template class Studio<LocalLightTraits<>>;
template class Studio<SeeThroughTraits<>>;
template class Studio<SeeThroughTraits<Rgb565, Depth24<>, Spanning>>;
template class Studio<TextureTraits<>>;
template class Studio<TextureTraits<Rgb565, Depth24<>>>;
template class Studio<TextureTraits<Rgb565, Depth24<>, Spanning>>;
template class Studio<TextureTraits<Rgb565, Depth16<>, Counted>>;
template class Studio<FoggedTextureTraits<>>;
template class Studio<FoggedTextureTraits<Rgb565, Depth24<>, Spanning>>;
template class Studio<IdTraits<>>;
template class Studio<IdTraits<Depth24<>>>;
template class Studio<Ids>;

}  // namespace spanline::test
