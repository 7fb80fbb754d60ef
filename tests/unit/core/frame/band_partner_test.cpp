// What a renderer and its partner promise beside the picture: memory, order of calls, colour bands, a sink that gives
// up.
#include "spanline/frame/band_partner.hpp"
#include "spanline/frame/ready_made_traits.hpp"
#include "spanline/model/cull.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "support/random.hpp"
#include "support/ready_made_studios.hpp"

namespace spanline::test {
namespace {

using Flat = FlatTraits<Rgb565, Depth24<>>;
using Spans = FlatTraits<Rgb565, Depth24<>, Spanning>;

constexpr int width = 40, height = 25;

/// A frame of a few random triangles, in nine bands of three lines.
class BandPartnerTest : public ::testing::Test {
 protected:
  template <class Traits>
  static bool submit(Renderer<Traits>& renderer) {
    static const auto corners = [] {
      Random random(7);
      std::vector<Corners> made(30);
      for (Corners& triangle : made)
        for (Corner& c : triangle)
          c = {random.between(-50, width * 16), random.between(-50, height * 16), random.between(1000, 9'000'000)};
      return made;
    }();
    static const auto vertices = vertices_of(corners, 24, width, height);
    static const std::vector<std::uint16_t> colours(corners.size(), 0x1234);
    FrameSettings settings;
    settings.cull = Cull::none;
    return renderer.begin(settings).ok() && renderer.add_screen(vertices, colours).ok();
  }
  static Capacity capacity(std::uint8_t colour_bands = 2) {
    Capacity c = screen_capacity(width, height, 30, 3);
    c.colour_bands = colour_bands;
    return c;
  }
};

/// Notes which bands came, and in which colour band.
struct Log {
  std::vector<int> lines;
  std::vector<unsigned> buffers, acquired;
  int stop_after = -1;
  bool acquire(unsigned buffer) {
    acquired.push_back(buffer);
    return true;
  }
  template <class Band>
  bool operator()(const Band& band) {
    lines.push_back(band.y0);
    buffers.push_back(band.buffer);
    return static_cast<int>(lines.size()) != stop_after;
  }
};

TEST_F(BandPartnerTest, EachDrawsItsOwnBandsIntoItsOwnMemoryByTurns) {
  std::vector<std::byte> memory(Renderer<Flat>::bytes_needed(capacity(3)));
  std::vector<std::byte> more(BandPartner<Flat>::bytes_needed(capacity(3)));
  Renderer<Flat> renderer(capacity(3), memory);
  BandPartner<Flat> partner(renderer, more);
  ASSERT_TRUE(partner.status().ok());
  ASSERT_TRUE(submit(renderer));
  ASSERT_TRUE(partner.take_frame().ok());
  Log even, odd;
  ASSERT_TRUE(renderer.draw_even(even).ok());
  ASSERT_TRUE(partner.draw_odd(odd).ok());
  EXPECT_EQ(even.lines, (std::vector<int>{0, 6, 12, 18, 24}));
  EXPECT_EQ(odd.lines, (std::vector<int>{3, 9, 15, 21}));
  EXPECT_EQ(even.buffers, (std::vector<unsigned>{0, 1, 2, 0, 1}));
  EXPECT_EQ(odd.buffers, (std::vector<unsigned>{0, 1, 2, 0}));
  EXPECT_EQ(odd.acquired, odd.buffers);

  // Three and more colour bands go on where the last frame ended.
  ASSERT_TRUE(submit(renderer));
  ASSERT_TRUE(partner.take_frame().ok());
  Log next_even, next_odd;
  ASSERT_TRUE(renderer.draw_even(next_even).ok());
  ASSERT_TRUE(partner.draw_odd(next_odd).ok());
  EXPECT_EQ(next_even.buffers.front(), 2U);
  EXPECT_EQ(next_odd.buffers.front(), 1U);
  EXPECT_NE(partner.colour_band(0).data(), renderer.colour_band(0).data());
  EXPECT_TRUE(partner.colour_band(3).empty());
}

TEST_F(BandPartnerTest, MemoryThatIsShortIsRefused) {
  std::vector<std::byte> memory(Renderer<Spans>::bytes_needed(capacity()));
  Renderer<Spans> renderer(capacity(), memory);
  const std::size_t bytes = BandPartner<Spans>::bytes_needed(capacity());
  std::vector<std::byte> more(bytes - Arena::alignment);
  BandPartner<Spans> partner(renderer, more);
  EXPECT_EQ(partner.status(), (Status{Fault::pool_full, Pool::memory, static_cast<std::uint32_t>(bytes)}));
  ASSERT_TRUE(submit(renderer));
  EXPECT_EQ(partner.take_frame().fault, Fault::pool_full);
  EXPECT_EQ(partner.draw_odd(Log{}).fault, Fault::pool_full);
}

TEST_F(BandPartnerTest, AFrameIsDrawnOnce) {
  std::vector<std::byte> memory(Renderer<Flat>::bytes_needed(capacity()));
  std::vector<std::byte> more(BandPartner<Flat>::bytes_needed(capacity()));
  Renderer<Flat> renderer(capacity(), memory);
  BandPartner<Flat> partner(renderer, more);
  EXPECT_EQ(partner.draw_odd(Log{}).fault, Fault::no_frame);
  ASSERT_TRUE(submit(renderer));
  ASSERT_TRUE(partner.take_frame().ok());
  EXPECT_TRUE(partner.draw_odd(Log{}).ok());
  EXPECT_EQ(partner.draw_odd(Log{}).fault, Fault::no_frame);
}

TEST_F(BandPartnerTest, ASinkMayGiveItsFrameUp) {
  std::vector<std::byte> memory(Renderer<Spans>::bytes_needed(capacity()));
  std::vector<std::byte> more(BandPartner<Spans>::bytes_needed(capacity()));
  Renderer<Spans> renderer(capacity(), memory);
  BandPartner<Spans> partner(renderer, more);
  ASSERT_TRUE(submit(renderer));
  ASSERT_TRUE(partner.take_frame().ok());
  Log odd;
  odd.stop_after = 2;
  EXPECT_EQ(partner.draw_odd(odd).fault, Fault::sink_failed);
  EXPECT_EQ(odd.lines.size(), 2U);
  Log even;
  EXPECT_TRUE(renderer.draw_even(even).ok());
  EXPECT_EQ(even.lines.size(), 5U);
}

}  // namespace
}  // namespace spanline::test
