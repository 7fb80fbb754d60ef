// The record of filled columns and the set of a polygon's open pixels, against tables of bool.
#include "spanline/visibility/filled/filled_columns.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

#include "spanline/visibility/sort/open_pixels.hpp"
#include "support/effort.hpp"
#include "support/random.hpp"

namespace spanline::test {
namespace {

/// Widths about the ends of words and cells, the greatest ones, and any.
int any_width(Random& random) {
  constexpr int chosen[] = {1, 31, 32, 33, 63, 64, 65, 96, 320, 992, 1023, 1024, 1025, 1056, 1087, 1088, 2016, 2047};
  if (random.chance(3)) return random.between(1, 2047);
  return chosen[random.between(0, static_cast<int>(std::size(chosen)) - 1)];
}

RowColumns any_run(Random& random, int width) {
  const int first = random.between(0, width - 1);
  int end = random.between(first + 1, width);
  if (random.chance(3)) end = std::min(end, first + random.between(1, 40));
  if (random.chance(6)) return {0, width};
  return {first, end};
}

/// The runs of columns in [0, width) for which `holds`.
template <class Holds>
std::vector<RowColumns> runs_of(int width, Holds holds) {
  std::vector<RowColumns> runs;
  for (int x = 0; x < width; ++x) {
    if (!holds(x)) continue;
    if (runs.empty() || runs.back().end != x) runs.push_back({x, x});
    runs.back().end = x + 1;
  }
  return runs;
}

std::vector<std::pair<int, int>> pairs_of(const std::vector<RowColumns>& runs) {
  std::vector<std::pair<int, int>> pairs;
  for (const RowColumns& run : runs) pairs.emplace_back(run.first, run.end);
  return pairs;
}

/// A band of filled columns, and a bool for each of its pixels.
struct Band {
  Band(int columns, int rows)
      : width(columns),
        lines(rows),
        filled_pixels(static_cast<std::size_t>(rows), std::vector<bool>(static_cast<std::size_t>(columns))) {
    Arena counting;
    take(counting);
    memory.resize(counting.size(), std::byte{0x5a});
    Arena arena(memory);
    take(arena);
    filled.begin_band(width, lines);
  }
  Band(const Band&) = delete;
  Band& operator=(const Band&) = delete;
  Band(Band&&) = delete;
  Band& operator=(Band&&) = delete;
  ~Band() = default;

  void take(Arena& arena) {
    filled.take(arena, static_cast<std::size_t>(width), static_cast<std::size_t>(lines));
    open.take(arena, static_cast<std::size_t>(width), static_cast<std::size_t>(lines));
  }
  [[nodiscard]] bool is_filled(int x, int line) const {
    return filled_pixels[static_cast<std::size_t>(line)][static_cast<std::size_t>(x)];
  }
  void set_filled(RowColumns run, int line) {
    auto& row = filled_pixels[static_cast<std::size_t>(line)];
    std::fill(row.begin() + run.first, row.begin() + run.end, true);
  }
  /// Fills a run of a line, and expects that its gaps are handed out.
  void fill(RowColumns run, int line) {
    const auto want = runs_of(width, [&](int x) { return x >= run.first && x < run.end && !is_filled(x, line); });
    std::vector<RowColumns> got;
    filled.fill(filled.line(line), run, [&](RowColumns columns) { got.push_back(columns); });
    ASSERT_EQ(pairs_of(got), pairs_of(want)) << run.first << " to " << run.end << " of " << width;
    set_filled(run, line);
  }
  [[nodiscard]] bool all_filled(int first, int end) const {
    for (const auto& row : filled_pixels)
      if (std::find(row.begin() + first, row.begin() + end, false) != row.begin() + end) return false;
    return true;
  }
  void expect_that_the_record_agrees() const {
    for (int line = 0; line < lines; ++line) {
      std::vector<RowColumns> gaps;
      FilledColumns reader = filled;  // whose lines are not const
      filled.for_each_gap(reader.line(line), [&](RowColumns columns) { gaps.push_back(columns); });
      ASSERT_EQ(pairs_of(gaps), pairs_of(runs_of(width, [&](int x) { return !is_filled(x, line); })));
    }
    ASSERT_EQ(filled.full(), all_filled(0, width));
  }
  /// A cell is closed as soon as all of its pixels are filled.
  void expect_that_cells_agree(RowColumns run) const {
    const int cell = width > 1024 ? 64 : 32;
    const int first = run.first / cell * cell, end = std::min((run.end + cell - 1) / cell * cell, width);
    ASSERT_EQ(filled.is_closed(run.first, run.end), all_filled(first, end)) << run.first << ", " << run.end;
  }

  int width, lines;
  std::vector<std::byte> memory;
  FilledColumns filled;
  OpenPixels open;
  std::vector<std::vector<bool>> filled_pixels;
};

TEST(FilledColumns, FillGapsOnceAndCloseCellsThatAreFull) {
  Random random(1);
  int closed = 0, full = 0;
  for (int round = 0; round < rounds(1500); ++round) {
    Band band(any_width(random), random.between(1, 4));
    for (int step = 0; step < 40; ++step) {
      band.fill(any_run(random, band.width), random.between(0, band.lines - 1));
      const RowColumns columns = any_run(random, band.width);
      band.expect_that_cells_agree(columns);
      closed += band.filled.is_closed(columns.first, columns.end) ? 1 : 0;
      if (step % 8 == 0) band.expect_that_the_record_agrees();
      if (HasFatalFailure()) FAIL() << "round " << round << ", width " << band.width;
    }
    full += band.filled.full() ? 1 : 0;
    if (round % 2 == 0) continue;
    // The next band begins empty.
    band.filled.begin_band(band.width, band.lines);
    for (auto& row : band.filled_pixels) row.assign(row.size(), false);
    band.expect_that_the_record_agrees();
    if (HasFatalFailure()) FAIL() << "round " << round << ", width " << band.width;
  }
  EXPECT_GT(closed, rounds(1500));
  EXPECT_GT(full, rounds(1500) / 10);
}

TEST(FilledColumns, EveryWidthHasItsColumnsAndNoOthers) {
  for (unsigned width = 1; width <= 2047; width += stride(7)) {
    Band band(static_cast<int>(width), 2);
    band.expect_that_the_record_agrees();
    band.fill({0, band.width}, 0);
    if (band.width > 1) band.fill({0, band.width - 1}, 1);
    band.expect_that_the_record_agrees();
    band.fill({band.width - 1, band.width}, 1);
    band.expect_that_the_record_agrees();
    ASSERT_TRUE(band.filled.full());
    if (HasFatalFailure()) FAIL() << "width " << width;
  }
}

/// A polygon's open pixels beside a bool for each.
class OpenPixelsOfPolygons : public ::testing::Test {
 protected:
  using Pixels = std::vector<std::vector<bool>>;

  /// Adds a polygon of random runs to an empty set. Some lines have none.
  static Pixels add_polygon(Random& random, Band& band, std::vector<RowColumns>& runs) {
    Pixels open(static_cast<std::size_t>(band.lines), std::vector<bool>(static_cast<std::size_t>(band.width)));
    runs.assign(static_cast<std::size_t>(band.lines), {0, 0});
    const int first_line = random.between(0, band.lines - 1);
    OpenPixels::Line at = band.open.begin(first_line, band.lines);
    for (int line = first_line; line < band.lines; ++line, at.step()) {
      if (random.chance(4)) continue;
      const RowColumns run = any_run(random, band.width);
      runs[static_cast<std::size_t>(line)] = run;
      OpenPixels::open(at, run, band.filled.line(line));
      for (int x = run.first; x < run.end; ++x)
        open[static_cast<std::size_t>(line)][static_cast<std::size_t>(x)] = !band.is_filled(x, line);
    }
    return open;
  }
  static void close_some(Random& random, Band& band, const std::vector<RowColumns>& runs, Pixels& open) {
    const int line = random.between(0, band.lines - 1);
    if (line < band.open.first_line() || line >= band.open.end_line()) return;
    const RowColumns own = runs[static_cast<std::size_t>(line)], other = any_run(random, band.width);
    const RowColumns common = band.open.common(line, other);
    // A line's outermost columns move inwards as pixels are taken, but no open pixel is left out.
    if (common.first < common.end) {
      ASSERT_GE(common.first, std::max(own.first, other.first));
      ASSERT_LE(common.end, std::min(own.end, other.end));
    }
    auto& row = open[static_cast<std::size_t>(line)];
    for (int x = std::max(own.first, other.first); x < std::min(own.end, other.end); ++x) {
      const bool is_open = row[static_cast<std::size_t>(x)];
      ASSERT_TRUE(!is_open || (common.first <= x && x < common.end));
    }
    if (common.first >= common.end) return;
    const auto first = row.begin() + common.first, end = row.begin() + common.end;
    const bool any = std::find(first, end, true) != end;
    ASSERT_EQ(band.open.any(line, common), any);
    ASSERT_EQ(band.open.close(line, common) != 0, any);
    ASSERT_FALSE(band.open.any(line, common));
    std::fill(first, end, false);
  }
  static void tighten(Band& band, const Pixels& open, bool& any) {
    constexpr int top = 5;
    const BoxScale scale(Viewport{band.width, top + band.lines});
    int first_line = -1, end_line = 0, first_column = band.width, end_column = 0;
    for (int line = 0; line < band.lines; ++line)
      for (const RowColumns& run : runs_of(
               band.width, [&](int x) { return open[static_cast<std::size_t>(line)][static_cast<std::size_t>(x)]; })) {
        if (first_line < 0) first_line = line;
        end_line = line + 1;
        first_column = std::min(first_column, run.first);
        end_column = std::max(end_column, run.end);
      }
    PackedBox box;
    any = band.open.tighten(top, scale, box);
    ASSERT_EQ(any, first_line >= 0);
    if (!any) return;
    ASSERT_EQ(band.open.first_line(), first_line);
    ASSERT_EQ(band.open.end_line(), end_line);
    ASSERT_LE(box.first_row(scale), top + first_line);
    ASSERT_GE(box.end_row(scale), top + end_line);
    ASSERT_LE(box.first_column(scale), first_column);
    ASSERT_GE(box.end_column(scale), end_column);
    const int unit = 1 << scale.columns;
    ASSERT_GT(box.first_column(scale), first_column / 32 * 32 - unit);
    ASSERT_LT(box.end_column(scale), (end_column + 31) / 32 * 32 + unit);
  }
  static void fill_what_is_open(Band& band, const Pixels& open) {
    std::vector<std::vector<RowColumns>> got(static_cast<std::size_t>(band.lines));
    int stepped_to = band.open.first_line() - 1;
    band.open.fill_into(
        band.filled, [&] { ++stepped_to; },
        [&](std::int32_t line, RowColumns columns) {
          ASSERT_EQ(line, stepped_to);
          got[static_cast<std::size_t>(line)].push_back(columns);
          band.set_filled(columns, line);
        });
    for (int line = 0; line < band.lines; ++line) {
      const auto& row = open[static_cast<std::size_t>(line)];
      ASSERT_EQ(pairs_of(got[static_cast<std::size_t>(line)]),
                pairs_of(runs_of(band.width, [&](int x) { return row[static_cast<std::size_t>(x)]; })));
    }
  }
};

TEST_F(OpenPixelsOfPolygons, AreWhatIsNotFilledLessWhatWasTaken) {
  Random random(2);
  int filled = 0, empty = 0;
  for (int round = 0; round < rounds(1500); ++round) {
    Band band(any_width(random), random.between(1, 6));
    for (int polygon = 0; polygon < 6; ++polygon) {
      std::vector<RowColumns> runs;
      Pixels open = add_polygon(random, band, runs);
      bool any = true;
      for (int step = random.between(0, 6); step > 0 && any; --step) {
        close_some(random, band, runs, open);
        tighten(band, open, any);
        if (HasFatalFailure()) FAIL() << "round " << round << ", width " << band.width;
      }
      ++(any ? filled : empty);
      if (any) fill_what_is_open(band, open);
      band.expect_that_the_record_agrees();
      band.expect_that_cells_agree({0, band.width});
      if (HasFatalFailure()) FAIL() << "round " << round << ", width " << band.width;
    }
  }
  EXPECT_GT(filled, rounds(1500));
  EXPECT_GT(empty, rounds(1500) / 4);
}

}  // namespace
}  // namespace spanline::test
