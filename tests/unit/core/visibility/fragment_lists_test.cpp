// The pool of see-through fragments against its rule: a pixel keeps its nearest fragments, and where the pool is full
// its farthest one is laid at once.
#include "spanline/visibility/zbuffer/fragment_lists.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "spanline/memory/arena.hpp"
#include "spanline/raster/depth_format.hpp"
#include "support/effort.hpp"
#include "support/random.hpp"

namespace spanline::test {
namespace {

/// A pixel that remembers which layers were laid over it, in order.
using Trace = std::vector<int>;
struct Noted {
  int number;
  void over(Trace& below) const { below.push_back(number); }
};

using Depth = Depth16<>;
using Lists = FragmentLists<Depth, Trace, Noted>;

/// The rule, by lists that grow: of each pixel the fragments that wait, nearest first.
struct Model {
  struct Waiting {
    Depth::Word depth;
    int number;
  };
  std::vector<std::vector<Waiting>> waiting;
  std::vector<Trace> pixels;
  std::size_t free;

  Model(std::size_t count, std::size_t room) : waiting(count), pixels(count), free(room) {}

  void add(std::size_t pixel, Depth::Word depth, int number) {
    std::vector<Waiting>& list = waiting[pixel];
    const auto place = std::find_if(list.begin(), list.end(), [&](const Waiting& w) { return w.depth > depth; });
    list.insert(place, {depth, number});
    if (free > 0) {
      --free;
    } else {
      pixels[pixel].push_back(list.back().number);
      list.pop_back();
    }
  }
  void finish() {
    for (std::size_t i = 0; i < pixels.size(); ++i)
      for (auto w = waiting[i].rbegin(); w != waiting[i].rend(); ++w) pixels[i].push_back(w->number);
  }
};

TEST(FragmentLists, LayTheFarthestOfAPixelAtOnceWhereThePoolIsFull) {
  Random random(1);
  for (int round = 0; round < rounds(400); ++round) {
    const auto pixels = static_cast<std::size_t>(random.between(1, 4)),
               room = static_cast<std::size_t>(random.between(0, 12));
    std::vector<std::byte> memory(4096);
    Arena arena(memory);
    Lists lists;
    lists.take(arena, pixels, room);
    lists.begin_frame();
    Model model(pixels, room);
    std::vector<Trace> got(pixels);
    const int count = random.between(1, 30);
    for (int number = 0; number < count; ++number) {
      const auto pixel = static_cast<std::size_t>(random.between(0, static_cast<int>(pixels) - 1));
      const auto depth = static_cast<Depth::Word>(random.between(1, 9));
      lists.add(pixel, depth, {number}, Depth::clear, got[pixel]);
      model.add(pixel, depth, number);
    }
    const std::vector<Depth::Word> background(pixels, Depth::clear);
    lists.finish_band(background.data(), got.data(), pixels);
    model.finish();
    ASSERT_EQ(got, model.pixels) << "round " << round;
    EXPECT_EQ(lists.wanted(), static_cast<std::uint32_t>(count));
    EXPECT_EQ(lists.overflowed(), static_cast<std::size_t>(count) > room);
  }
}

}  // namespace
}  // namespace spanline::test
