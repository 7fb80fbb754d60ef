// Runs without a depth test: each pixel is what its source gives, and none beside the run is touched.
#include "spanline/shade/fill_run.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "spanline/shade/light/flat.hpp"
#include "spanline/shade/light/gouraud.hpp"

namespace spanline::test {
namespace {

/// Fills every run of up to 101 pixels at every alignment, and compares with `expected(column)`.
template <class Pixel, class Surface, class Expected>
void check_every_run(const Surface& surface, Expected expected) {
  constexpr Pixel untouched = 0xabcd;
  for (std::uint32_t count = 1; count <= 101; ++count) {
    for (std::size_t first = 0; first < 6; ++first) {
      std::vector<Pixel> line(120, untouched);
      fill_run(surface, static_cast<std::int32_t>(first), count, line.data() + first);
      for (std::size_t x = 0; x < line.size(); ++x) {
        const bool inside = x >= first && x < first + count;
        ASSERT_EQ(line[x], inside ? expected(static_cast<std::int32_t>(x)) : untouched)
            << "run of " << count << " at " << first << ", column " << x;
      }
    }
  }
}

TEST(FillRun, FlatRunsAreFilledWholeAndNothingElse) {
  check_every_run<std::uint16_t>(FlatShader<Rgb565>::Surface{0x1234}, [](std::int32_t) { return 0x1234; });
  check_every_run<std::uint32_t>(FlatShader<PolygonIds>::Surface{0x123456u}, [](std::int32_t) { return 0x123456u; });
}

TEST(FillRun, SteppedRunsTakeEachPixelFromItsColumn) {
  std::vector<std::uint16_t> ramp(gouraud::ramp_size);
  for (std::size_t i = 0; i < ramp.size(); ++i) ramp[i] = static_cast<std::uint16_t>(7 * i + 1);
  const GouraudShader<Rgb565>::Surface surface{{0x1000'0000, 0x0200'0001, 5}, ramp.data()};
  check_every_run<std::uint16_t>(surface,
                                 [&](std::int32_t column) { return ramp[surface.intensity.at(column) >> 26]; });
}

/// A surface of blocks of 16 columns that begin at screen column −3: each block counts on from a number of its own.
struct Stairs {
  struct Source {
    static constexpr bool constant = false;
    std::uint16_t value;
    [[nodiscard]] std::uint16_t get() const { return value; }
    void forward() { ++value; }
    void back() { --value; }
    void next_piece() {}
  };
  struct Blocks {
    std::int32_t column;
    [[nodiscard]] std::uint32_t rest_of_block() const { return rest(); }
    [[nodiscard]] std::uint32_t rest() const { return 16 - static_cast<std::uint32_t>((column + 3) & 15); }
    [[nodiscard]] Source source() const { return {value_at(column)}; }
    void next() { column += static_cast<std::int32_t>(rest()); }
  };
  static std::uint16_t value_at(std::int32_t column) {
    return static_cast<std::uint16_t>(100 * ((column + 3) >> 4) + ((column + 3) & 15));
  }
  [[nodiscard]] Blocks blocks(std::int32_t column) const { return {column}; }
};

TEST(FillRun, BlocksAreCutAtTheirOwnColumnsWhereverARunBegins) {
  check_every_run<std::uint16_t>(Stairs{}, [](std::int32_t column) { return Stairs::value_at(column); });
}

}  // namespace
}  // namespace spanline::test
