// A visibility algorithm that draws nothing, as the smallest that satisfies the concept; contract_words.py compiles it
// whole, and without one function at a time.
#include "spanline/frame/ready_made_traits.hpp"
#include "spanline/frame/renderer.hpp"

namespace spanline {

template <class Depth, class Pixel>
struct DrawsNothing {
  using Target = BandTarget<Depth, Pixel>;
  static constexpr AlgorithmNeeds needs = AlgorithmNeeds::screen_polygons;
  static constexpr bool keeps_depth = false, tests_depth = false, takes_table_apart = false, clears_ahead = true;
  static constexpr std::span<const std::string_view> counter_names{};
  struct Memory {
    constexpr void take(Arena& /*arena*/, const Capacity& /*capacity*/) {}
  };
  static constexpr bool takes(const Capacity& /*capacity*/) { return true; }
  static constexpr std::uint32_t bucket_lines(const Capacity& capacity) { return capacity.height; }
  DrawsNothing() = default;
  explicit DrawsNothing(const Memory& /*memory*/) {}
#ifndef WITHOUT_BEGIN_FRAME
  void begin_frame(const FrameInput& /*input*/) {}
#endif
  template <class Fill>
  void clear(const Target& target, Fill fill) {
    fill(target.background, static_cast<std::uint32_t>(target.width * (target.end_row - target.first_row)),
         target.pixels);
  }
#ifndef WITHOUT_DRAW_BAND
  template <class Group, class Covered>
  void draw_band(const PolygonTable& /*table*/, std::span<const Group> /*shading*/, std::int32_t /*band*/,
                 Viewport /*viewport*/, const Target& /*target*/, Covered&& /*covered*/) {}
#endif
#ifndef WITHOUT_SKIP_BAND
  template <class Group>
  void skip_band(const PolygonTable& /*table*/, std::span<const Group> /*shading*/, std::int32_t /*band*/,
                 Viewport /*viewport*/, const Target& /*target*/) {}
#endif
#ifndef WITHOUT_SHORTAGE
  [[nodiscard]] PoolShortage shortage(const FrameInput& /*input*/) const { return {}; }
#endif
  void note_peaks(PoolPeaks& /*peaks*/) const {}
};

struct Nothing {
  template <class Depth, class Pixel, class Shaders, bool Counting>
  using Algorithm = DrawsNothing<Depth, Pixel>;
};

template class Renderer<FlatTraits<Rgb565, Nothing>>;

}  // namespace spanline
