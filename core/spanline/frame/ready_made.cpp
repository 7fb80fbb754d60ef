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
template class Renderer<FlatTraits<Rgb565, Depth24<>, Painter>>;
template class Renderer<FlatTraits<Rgb565, Depth24<>, DepthSort>>;
template class Renderer<GouraudTraits<Rgb565, Depth24<>, DepthSort>>;
template class Renderer<TextureTraits<Rgb565>>;
template class Renderer<TextureTraits<Rgb565Swapped>>;
template class Renderer<TextureTraits<Rgb565, Depth24<>>>;
template class Renderer<TextureTraits<Rgb565, Depth24<>, Spanning>>;
template class Renderer<SeeThroughTraits<Rgb565>>;
template class Renderer<SeeThroughTraits<Rgb565, Depth24<>, Spanning>>;
template class Renderer<SeeThroughTraits<Rgb565, Depth24<>, Painter>>;
template class Renderer<SeeThroughTraits<Rgb565, Depth24<>, DepthSort>>;

// The table of docs/visibility.md: how many polygons `Spanning` can have active on a row on a 32-bit core.
namespace {

template <template <class, class...> class Traits>
constexpr bool has_awake_at_most(std::uint32_t most) {
  using Spans = Renderer<Traits<Rgb565, Depth24<>, Spanning>>;
  return sizeof(void*) > 4 || (Spans::takes({.awake = most}) && !Spans::takes({.awake = most + 1}));
}
static_assert(has_awake_at_most<FlatTraits>(744));
static_assert(has_awake_at_most<GouraudTraits>(546));
static_assert(has_awake_at_most<LocalLightTraits>(546));
static_assert(has_awake_at_most<SeeThroughTraits>(496));
static_assert(has_awake_at_most<TextureTraits>(399));
static_assert(has_awake_at_most<FoggedTextureTraits>(348));
static_assert(has_awake_at_most<GeneralTraits>(303));
static_assert(has_awake_at_most<GeneralSeeThroughTraits>(287));

}  // namespace

}  // namespace spanline
