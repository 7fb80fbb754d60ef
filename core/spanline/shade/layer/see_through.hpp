#pragma once
#include <cstddef>
#include <cstdint>
#include <limits>
#include <new>
#include <utility>

#include "spanline/math/bits.hpp"
#include "spanline/model/material.hpp"
#include "spanline/pixel/premultiplied.hpp"
#include "spanline/raster/make_surface.hpp"
#include "spanline/raster/polygon_corners.hpp"
#include "spanline/raster/span.hpp"
#include "spanline/raster/surface_blocks.hpp"
#include "spanline/shade/fill_run.hpp"
#include "spanline/shade/layer/layering.hpp"
#include "spanline/shade/layer/stipple.hpp"
#include "spanline/shade/shading_group.hpp"

namespace spanline {

/// A source of pixels whose opacity varies. `opacity()` is in 255ths of the material's opacity, `translucent()` gives
/// colour and opacity together, and two functions give the position on screen.
template <class S>
concept TranslucentSource = requires(const S& view) {
  { view.opacity() } -> std::convertible_to<std::uint32_t>;
  view.translucent();
  view.screen_column();
  view.screen_row();
};

/// Makes any shader see-through, by mixing colours or by leaving pixels out, as the group's material says.
template <class Format, class InnerShader>
struct SeeThroughShader {
  using Inner = InnerShader;
  using Pixel = typename Format::Pixel;
  using Layer = PixelLayer<Format>;
  static constexpr bool see_through = true;
  static constexpr bool interpolates = true;

  struct Surface;

  /// A source of an inner surface whose opacity varies, so that each pixel has its own level.
  template <class InnerSource>
  struct VaryingSource : InnerSource {
    static constexpr bool constant = false;
    static constexpr bool has_holes = true;
    std::uint32_t owner;
    Layering layering;

    [[nodiscard]] bool present() const {
      if (!InnerSource::present()) return false;
      const std::uint32_t level = level_at(layering, InnerSource::opacity());
      if (mixes(layering)) return level != 0;
      const auto x = word(InnerSource::screen_column()), y = word(InnerSource::screen_row());
      const std::uint32_t threshold = is(layering, Transparency::screen_door)
                                          ? stipple::ordered_threshold(owner, x, y)
                                          : stipple::random_threshold(owner, x, y, layering.variant);
      return threshold < level;
    }
    [[nodiscard]] Layer layer() const {
      const auto pixel = InnerSource::translucent();
      return {Format::from_rgb565(pixel.rgb565), static_cast<std::uint8_t>(level_at(layering, pixel.opacity)),
              is(layering, Transparency::add)};
    }
  };

  /// A source of the inner surface with the bits of a stipple pattern; bit 0 belongs to the current pixel.
  template <class InnerSource>
  struct Source : InnerSource {
    static constexpr bool constant = false;
    static constexpr bool has_holes = true;
    std::uint32_t mask;
    Layering layering;

    [[nodiscard]] bool present() const {
      if constexpr (SourceWithHoles<InnerSource>) return (mask & 1) != 0 && InnerSource::present();
      return (mask & 1) != 0;
    }
    [[nodiscard]] Layer layer() const {
      return {InnerSource::get(), static_cast<std::uint8_t>(layering.level), is(layering, Transparency::add)};
    }
    void forward() {
      InnerSource::forward();
      mask = mask >> 1 | mask << 31;
    }
    void back() {
      InnerSource::back();
      mask = mask << 1 | mask >> 31;
    }
    void next_piece() {
      if constexpr (requires(InnerSource & source) { source.next_piece(); }) InnerSource::next_piece();
    }
  };

  /// The inner surface's blocks. Where there is a stipple pattern, they are also cut at multiples of 32 screen columns.
  class Blocks {
   public:
    Blocks(const Surface& surface, std::int32_t column) : surface_(surface), inner_(surface.inner, column) {
      place(column);
    }
    [[nodiscard]] std::uint32_t rest() const { return inner_.rest() < rest_ ? inner_.rest() : rest_; }
    [[nodiscard]] std::uint32_t rest_of_block() const { return rest_; }
    [[nodiscard]] auto source() const {
      using InnerSource = decltype(inner_.source());
      if constexpr (varies)
        return VaryingSource<InnerSource>{inner_.source(), surface_.owner, surface_.layering};
      else
        return Source<InnerSource>{inner_.source(), mask_, surface_.layering};
    }
    void next() {
      inner_.move(rest_);
      place(inner_.column());
    }

   private:
    void place(std::int32_t column) {
      rest_ = inner_.rest_of_block();
      mask_ = ~std::uint32_t{0};
      if (varies || surface_.blends()) return;
      const std::uint32_t x = word(column + surface_.origin), into = x & 31;
      if (32 - into < rest_) rest_ = 32 - into;
      mask_ = surface_.mask(x - into);
      mask_ = mask_ >> into | mask_ << ((32 - into) & 31);
    }

    /// Gives inner surfaces with and without blocks the same interface, that of blocks.
    class InnerWalk {
     public:
      InnerWalk(const typename Inner::Surface& surface, std::int32_t column)
          : surface_(surface), walk_(at(surface, column)), column_(column) {}
      [[nodiscard]] std::int32_t column() const { return column_; }
      [[nodiscard]] std::uint32_t rest() const {
        if constexpr (in_blocks)
          return walk_.rest();
        else
          return unbounded;
      }
      [[nodiscard]] std::uint32_t rest_of_block() const {
        if constexpr (in_blocks)
          return walk_.rest_of_block();
        else
          return unbounded;
      }
      [[nodiscard]] auto source() const {
        if constexpr (in_blocks)
          return walk_.source();
        else
          return walk_;
      }
      void move(std::uint32_t columns) {
        column_ += signed_word(columns);
        if constexpr (in_blocks) {
          if (columns == walk_.rest_of_block()) {
            walk_.next();
            return;
          }
          // A block is cut by the pattern only on affine textures, where one source serves the whole row.
          new (&walk_) Walk(at(surface_, column_));
        } else {
          walk_ = at(surface_, column_);
        }
      }

     private:
      static constexpr std::uint32_t unbounded = std::numeric_limits<std::uint32_t>::max();
      static constexpr bool in_blocks = SurfaceInBlocks<typename Inner::Surface>;
      static auto at(const typename Inner::Surface& surface, std::int32_t column) {
        if constexpr (in_blocks)
          return surface.blocks(column);
        else
          return surface.source(column);
      }
      using Walk = decltype(at(std::declval<const typename Inner::Surface&>(), 0));
      const typename Inner::Surface& surface_;
      Walk walk_;
      std::int32_t column_;
    };

    static constexpr bool varies = TranslucentSource<decltype(std::declval<const InnerWalk&>().source())>;

    const Surface& surface_;
    InnerWalk inner_;
    std::uint32_t rest_ = 0, mask_ = 0;
  };

  struct Surface {
    typename Inner::Surface inner;
    std::uint32_t owner;  ///< number that selects the surface's stipple pattern
    Layering layering;
    std::int16_t origin;  ///< screen column of column 0
    std::uint16_t row;    ///< screen row, pixels

    void next_row() {
      inner.next_row();
      ++row;
    }
    void skip_rows(std::int32_t rows) {
      inner.skip_rows(rows);
      row = static_cast<std::uint16_t>(row + rows);
    }
    [[nodiscard]] Blocks blocks(std::int32_t column) const { return {*this, column}; }
    [[nodiscard]] bool blends() const { return mixes(layering); }
    /// The pattern's bits for the 32 columns from `x` on; x is a multiple of 32.
    [[nodiscard]] std::uint32_t mask(std::uint32_t x) const {
      return is(layering, Transparency::screen_door)
                 ? stipple::ordered_mask(owner, layering.level, row)
                 : stipple::random_mask(owner, layering.level, x, row, layering.variant);
    }

    /// Composes a run over the pixels behind it.
    [[gnu::noinline]] void lay(std::int32_t column, std::uint32_t count, Pixel* pixels) const {
      if (!blends()) {
        fill_detail::fill_blocks(pixels, count, blocks(column));
        return;
      }
      if constexpr (!SurfaceInBlocks<typename Inner::Surface>) {
        const auto source = inner.source(column);
        if constexpr (decltype(source)::constant) {
          if (is(layering, Transparency::blend)) {
            blend_constant<Format>(Premultiplied565::from(Format::from_rgb565(source.get()), layering.level), count,
                                   pixels);
            return;
          }
        }
      }
      for_each_pixel(blocks(column), count, [&](const auto& source) {
        if (source.present()) source.layer().over(*pixels);
        ++pixels;
      });
    }
  };

  template <class Gradients>
  static void make(Surface& surface, const ShadingGroup& group, const PolygonCorners& polygon,
                   const Gradients& gradients) {
    make_surface<Inner>(surface.inner, group, polygon, gradients);
    surface.layering = group.layering;
    surface.origin = static_cast<std::int16_t>(gradients.origin());
    surface.row = static_cast<std::uint16_t>(gradients.row());
    // Front and back of an instance overlap on screen, so each side has its own pattern.
    const std::uint32_t back = turned_away(polygon) ? 1 : 0;
    surface.owner =
        is(group.layering, Transparency::screen_door) ? group.layering.variant + 4 * back : 2 * group.first_id + back;
  }

 private:
  /// Whether the corners run clockwise on screen, which back faces do.
  [[nodiscard]] static bool turned_away(const PolygonCorners& polygon) {
    const auto [a, b, c] = polygon.corner;
    const auto product = [](std::int32_t p, std::int32_t q) { return static_cast<std::int64_t>(p) * q; };
    return product(b->x - a->x, c->y - a->y) > product(b->y - a->y, c->x - a->x);
  }
};

}  // namespace spanline
