// The renderers that most programs want, compiled into the library, so that the checks of its symbols (no heap, no
// floating point, no exceptions) see the templates as well.
#include "spanline/frame/ready_made_traits.hpp"
#include "spanline/frame/renderer.hpp"

namespace spanline {

template class Renderer<FlatTraits<Rgb565>>;
template class Renderer<FlatTraits<Rgb565Swapped>>;
template class Renderer<GouraudTraits<Rgb565>>;
template class Renderer<GouraudTraits<Rgb565Swapped>>;
template class Renderer<GouraudTraits<Rgb565, Depth24<>>>;
template class Renderer<FlatTraits<Rgb565, Depth16<>, BoundedZBuffer>>;
template class Renderer<FlatTraits<Rgb565, Depth24<>, Spanning>>;
template class Renderer<GouraudTraits<Rgb565, Depth24<>, Spanning>>;
template class Renderer<TextureTraits<Rgb565>>;
template class Renderer<TextureTraits<Rgb565Swapped>>;
template class Renderer<TextureTraits<Rgb565, Depth24<>>>;
template class Renderer<TextureTraits<Rgb565, Depth24<>, Spanning>>;
template class Renderer<SeeThroughTraits<Rgb565>>;
template class Renderer<SeeThroughTraits<Rgb565, Depth24<>, Spanning>>;

}  // namespace spanline
