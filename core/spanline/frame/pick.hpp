#pragma once
/// @file
/// What is seen at a pixel.
///
/// ```cpp
/// #include <spanline/frame/ready_made_traits.hpp>
///
/// using Ids = Renderer<IdTraits<Counted>>;
///
/// /// 1 + the number of the triangle at (x, y), or 0.
/// std::uint32_t triangle_at(Ids& ids, const FrameSettings& settings, const Mesh& mesh, int x, int y) {
///   Picked<Ids::Depth> picked;
///   if (!ids.begin(settings).ok() || !ids.add(mesh, {}, {}).ok()) return 0;
///   return pick(ids, x, y, picked).ok() ? picked.id : 0;
/// }
/// ```
#include <cstddef>
#include <cstdint>

#include "spanline/frame/renderer.hpp"

namespace spanline {

/// What is seen at a pixel: picking.
template <class Depth>
struct Picked {
  std::uint32_t id = 0;     ///< 1 + number of the triangle in order of submission; 0: the background
  std::uint32_t depth = 0;  ///< depth in the integers of the format; its clear value for the background
};

/// What `pick` is made of.
namespace pick_detail {

/// A sink that records one pixel and then abandons the frame.
template <class Traits>
struct Sink {
  std::int32_t x, y, width;
  Picked<typename Traits::Depth>& picked;
  bool found = false;

  template <class Band>
  bool operator()(const Band& band) {
    if (y >= band.y1) return true;
    const auto at = static_cast<std::size_t>((y - band.y0) * width + x);
    picked = {band.pixels[at], Traits::Depth::integer(band.depth[at])};
    found = true;
    return false;
  }
};

}  // namespace pick_detail

/// Finds the triangle that the frame shows at (x, y), and its depth there. The frame must have been begun and filled as
/// for `draw`; any visibility algorithm will do, and the renderer's own bands are used. The renderer's traits must be
/// `IdTraits` with statistics, which make every algorithm keep depths. Bands are drawn down to the one that holds y.
/// Returns outside_picture if the picture has no such pixel.
template <class Traits>
Status pick(Renderer<Traits>& renderer, std::int32_t x, std::int32_t y, Picked<typename Traits::Depth>& picked) {
  static_assert(Traits::statistics && Traits::Shaders::template index_of<IdShader> < Traits::Shaders::count);
  const Capacity& capacity = renderer.capacity();
  if (x < 0 || y < 0 || x >= capacity.width || y >= capacity.height) return Fault::outside_picture;
  pick_detail::Sink<Traits> sink{x, y, capacity.width, picked};
  const Status status = renderer.draw(sink);
  return sink.found ? renderer.end_bands() : status;
}

}  // namespace spanline
