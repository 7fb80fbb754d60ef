#pragma once
#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "spanline/raster/screen_vertex.hpp"

/// The narrow waist between visibility and shading.
///
/// Visibility finds the runs of pixels that a polygon owns, or may own, on a line; it never sees a colour. Shading
/// gives the pixels of such a run as a source that stands at one column and steps to either side; it never sees an
/// edge. Z-buffers fuse the two by templates, since they ask for a pixel only where its depth wins; algorithms that
/// know whole spans take them from left to right.
namespace spanline {

/// What a shader gives for a run: the pixel at the current column, and steps. `constant` says that all pixels are
/// alike.
template <class S>
concept PixelSource = requires(S source, const S& view) {
  { S::constant } -> std::convertible_to<bool>;
  view.get();
  source.forward();
  source.back();
};

/// A source whose surface has holes (cut-out textures): it tells whether there is anything at the current column.
template <class S>
concept SourceWithHoles = requires(const S& view) {
  { view.present() } -> std::convertible_to<bool>;
}
&&S::has_holes;

/// What a surface of blocks gives in the place of one source: a run cut at screen columns that belong to the surface
/// and not to the run, so that a pixel is the same wherever its run begins. It stands at a column; `rest_of_block` is
/// how many pixels one source serves from there, and `next` goes on behind them. Inside the block are pieces of 4
/// pixels, of which `rest` are left in the first; from one to the next the source is told to `bend`.
template <class B>
concept RunBlocks = requires(B blocks, const B& view) {
  { view.rest() } -> std::convertible_to<std::uint32_t>;
  { view.rest_of_block() } -> std::convertible_to<std::uint32_t>;
  { view.source() } -> PixelSource;
  view.source().bend();
  blocks.next();
};

/// A surface whose attributes are not linear over the screen (perspective textures): a run is drawn in pieces, each of
/// which is.
template <class S>
concept SurfaceInBlocks = requires(const S& surface, std::int32_t column) {
  { surface.blocks(column) } -> RunBlocks;
};

/// Calls visit(source) for each of the `count` ≥ 1 pixels from where `blocks` stands.
template <RunBlocks Blocks, class Visit>
[[gnu::always_inline]] inline void for_each_pixel(Blocks blocks, std::uint32_t count, Visit visit) {
  constexpr std::uint32_t columns_a_piece = 4;  // behind the first of a block
  for (;;) {
    std::uint32_t left = blocks.rest_of_block() < count ? blocks.rest_of_block() : count, piece = blocks.rest();
    count -= left;
    auto source = blocks.source();
    for (;;) {
      if (piece > left) piece = left;
      left -= piece;
      for (; piece != 0; --piece) {
        visit(source);
        source.forward();
      }
      if (left == 0) break;
      source.bend();
      piece = columns_a_piece;
    }
    if (count == 0) return;
    blocks.next();
  }
}

/// A surface whose blocks of 16 columns can be had some at a time: `certain(column, count)` says whether those of a run
/// can, and has the first at hand. `source(column)` then wants a block: it takes one up with `restart(block)`, where it
/// stands at the block's start, and with `restart(block, into)` at a column of it; bends by `bend(block)`; and is told
/// of the `next_block()`. `fill_blocks` draws whole ones without a depth test.
template <class S>
concept SurfaceInCertainBlocks = SurfaceInBlocks<S> && requires(const S& surface, std::int32_t column) {
  { surface.certain(column, 1u).certain() } -> std::convertible_to<bool>;
  { surface.source(column) } -> PixelSource;
};

/// One whose pixels are words of a table, at ((u >> 16) & mask_u) + ((v >> 12) & mask_v): loops in assembly know it.
template <class S>
concept TableSurface = SurfaceInCertainBlocks<S> && requires(const S& s) {
  { s.texels.table[0] } -> std::convertible_to<std::uint32_t>;
  { s.texels.mask_u + s.texels.mask_v } -> std::convertible_to<std::uint32_t>;
  { s.source(0).coordinates.du } -> std::convertible_to<std::uint32_t>;
  requires S::plain_texels;
};

/// Goes through the blocks of a run of `count` ≥ 1 pixels: part(column, block, into, pixels) for those that the run
/// cuts, `into` columns of which lie before it; whole(column, blocks, count) for whole ones. False, with nothing done,
/// where the surface cannot give them.
template <SurfaceInCertainBlocks Surface, class Part, class Whole>
[[gnu::always_inline]] inline bool for_certain_blocks(const Surface& surface, std::int32_t column, std::uint32_t count,
                                                      Part part, Whole whole) {
  auto certain = surface.certain(column, count);
  if (!certain.certain()) return false;
  constexpr std::uint32_t block = 16;
  std::uint32_t into = certain.into_block();
  const auto* next = certain.blocks();
  do {
    std::uint32_t wholes = certain.count();
    next = certain.blocks();
    if (into != 0) {
      const std::uint32_t pixels = block - into < count ? block - into : count;
      part(column, *next++, into, pixels);
      column += static_cast<std::int32_t>(pixels);
      count -= pixels;
      --wholes;
      into = 0;
    }
    if (wholes * block > count) --wholes;
    if (wholes == 0) continue;
    whole(column, next, wholes);
    column += static_cast<std::int32_t>(wholes * block);
    count -= wholes * block;
    next += wholes;
  } while (certain.next());
  if (count != 0) part(column, *next, 0, count);
  return true;
}

/// A shader of polygons that what lies behind may show through. Its surfaces come in blocks. `blends()` of a surface
/// tells whether its colours mix with those behind; otherwise it is opaque where it is present, and a depth test is all
/// that it takes. `layer()` of a source is the current pixel as a `Layer` of a few bytes, the same type for all shaders
/// of a list, whose `over(pixel)` lays it over a pixel.
template <class Shader>
concept SeeThrough = requires {
  requires Shader::see_through;
};

/// A surface whose pixels come from a table of 64 by the top bits of one linear function: loops in assembly know it.
template <class S>
concept RampSurface = requires(const S& surface) {
  { surface.intensity.at_origin } -> std::convertible_to<std::uint32_t>;
  { surface.ramp[0] } -> std::convertible_to<std::uint32_t>;
  requires S::ramp_bits == 6;
};

/// Numbers of polygons and vertices inside a frame: 16 bits on microcontrollers (65,534 polygons), 32 bits where
/// pointers have 64.
using Link = std::conditional_t<(sizeof(void*) > 4), std::uint32_t, std::uint16_t>;
inline constexpr Link no_link = std::numeric_limits<Link>::max();
/// A polygon as found in the table.
struct PolygonCorners {
  const ScreenVertex* corner[3];
  Link triangle;  ///< triangle number within the group
  Link polygon;   ///< polygon number within the mesh
};

/// Makes a shader's surface for a polygon, by what that shader asks for: the polygon, its gradients, or both.
template <class Shader, class Group, class Gradients>
[[gnu::always_inline]] inline void make_surface(typename Shader::Surface& surface, const Group& group,
                                                const PolygonCorners& polygon, const Gradients& gradients) {
  if constexpr (!Shader::interpolates)
    Shader::make(surface, group, polygon);
  else if constexpr (requires { Shader::make(surface, group, polygon, gradients); })
    Shader::make(surface, group, polygon, gradients);
  else
    Shader::make(surface, group, gradients);
}

}  // namespace spanline
