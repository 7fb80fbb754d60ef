#pragma once
#include <algorithm>
#include <cstdint>

#include "spanline/raster/row_columns.hpp"
#include "spanline/raster/surface_blocks.hpp"
#include "spanline/visibility/span/awake_polygon.hpp"

namespace spanline {

/// For algorithms without a depth buffer that count: they count the runs that they write, and write the runs' depths
/// for inspection, as a z-buffer would have left them.
template <class Depth, class Target>
class CountedRuns {
 public:
  /// Runs of `row`, not biased.
  CountedRuns(const Target& target, std::int32_t row)
      : target_(target), row_(row), depth_(target.depth + (row + row_bias - target.first_row) * target.width) {}

  void background(RowColumns columns) const { std::fill(depth_ + columns.first, depth_ + columns.end, Depth::clear); }
  /// A run of a polygon, which has a plane.
  void opaque(const AwakePolygon& polygon, RowColumns columns) const {
    ++target_.counters->spans;
    target_.counters->pixels += word(columns.end - columns.first);
    for (std::int32_t column = columns.first; column < columns.end; ++column) put_depth(polygon, column);
  }
  /// A run of a polygon that may be seen through; `surface` is on the row. Depths are written for opaque pixels only.
  template <class Shader>
  void see_through(const AwakePolygon& polygon, const typename Shader::Surface& surface, RowColumns columns) const {
    ++target_.counters->spans;
    if constexpr (SurfaceInBlocks<typename Shader::Surface>) {
      bool blends = false;
      if constexpr (SeeThrough<Shader>) blends = surface.blends();
      std::int32_t column = columns.first;
      for_each_pixel(surface.blocks(column), word(columns.end - column), [&]<class Source>(const Source& source) {
        const std::int32_t here = column++;
        if constexpr (SourceWithHoles<Source>) {
          if (!source.present()) return;
        }
        ++target_.counters->pixels;
        if (!blends) put_depth(polygon, here);
      });
    }
  }

 private:
  void put_depth(const AwakePolygon& polygon, std::int32_t column) const {
    const std::uint32_t plane_word = polygon.depth_at(column, row_);
    depth_[column] = static_cast<typename Depth::Word>(Depth::stored(Depth::smaller ? plane_word : ~plane_word));
  }

  const Target& target_;
  std::int32_t row_;
  typename Depth::Word* depth_;
};

}  // namespace spanline
