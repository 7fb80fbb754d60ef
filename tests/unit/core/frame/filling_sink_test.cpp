// Sinks behind which hardware clears bands while others are drawn: the same bytes, whenever it does its work.
#include <gtest/gtest.h>

#include <functional>
#include <utility>
#include <vector>

#include "spanline/frame/ready_made_traits.hpp"
#include "spanline/visibility/zbuffer/deferred.hpp"
#include "spanline/visibility/zbuffer/depth_buffer.hpp"
#include "support/owned_mesh.hpp"
#include "support/ready_made_studios.hpp"

namespace spanline::test {
namespace {

using namespace spanline::literals;

/// The bands of frames: pixels, and a sum of depths.
struct Kept {
  std::vector<std::pair<std::vector<std::uint16_t>, std::size_t>> bands;
  template <class Band>
  bool take(const Band& band) {
    std::size_t sum = 0;
    for (const auto depth : band.depth) sum = sum * 31 + depth;
    bands.push_back({{band.pixels.begin(), band.pixels.end()}, sum});
    return true;
  }
};

/// Keeps its fills until somebody waits for them, which is as late as hardware may be, or does them at once.
class LateSink {
 public:
  bool late = true;
  bool runs_ahead = true;            ///< buffers are free as soon as they are asked for
  std::size_t waits_to_fail = 9999;  ///< number of the wait that gives up
  int fills_while_drawing = 0;
  Kept kept;

  bool acquire(unsigned) { return true; }
  bool available(unsigned) const { return runs_ahead; }
  template <class Word>
  void fill(Word value, std::uint32_t count, Word* words) {
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(words) % Arena::alignment, 0U);
    EXPECT_LT(pending_.size(), 2U);
    pending_.push_back({words, words + count, [=] { std::fill_n(words, count, value); }});
    if (!late) pending_.back().run();
  }
  bool filled() {
    if (late)
      for (const Fill& fill : pending_) fill.run();
    pending_.clear();
    return waits_++ != waits_to_fail;
  }
  template <class Band>
  bool operator()(const Band& band) {
    for (const Fill& fill : pending_) {
      ++fills_while_drawing;
      EXPECT_TRUE(apart(fill, band.pixels) && apart(fill, band.depth)) << "the band that was drawn is being cleared";
    }
    return kept.take(band);
  }

 private:
  struct Fill {
    const void *first, *end;
    std::function<void()> run;
  };
  template <class Words>
  static bool apart(const Fill& fill, Words words) {
    return fill.end <= words.data() || fill.first >= words.data() + words.size();
  }
  std::vector<Fill> pending_;
  std::size_t waits_ = 0;
};

Capacity capacity_of(std::uint8_t depth_bands) {
  return {.width = 63,  // an odd number of pixels a band
          .height = 47,
          .band_lines = 9,
          .colour_bands = 3,
          .depth_bands = depth_bands,
          .instances = 4,
          .vertices = 40,
          .polygons = 40,
          .fans = 40,
          .active = 40};
}

template <class Traits>
class Frames {
 public:
  explicit Frames(const Capacity& capacity)
      : memory_(Renderer<Traits>::bytes_needed(capacity)), renderer_(capacity, memory_) {
    EXPECT_TRUE(renderer_.status().ok());
    transform_.translation.z = -4.0_q16;
  }
  template <class Sink>
  Status show(Sink&& sink, bool begin_early, Rgb888 background) {
    FrameSettings settings;
    settings.background = background;
    EXPECT_TRUE(renderer_.begin(settings).ok());
    if (begin_early) {
      if constexpr (requires { sink.filled(); }) renderer_.clear_ahead(sink);
    }
    EXPECT_TRUE(renderer_.add(mesh_, transform_, {}).ok());
    return renderer_.draw(sink);
  }

 private:
  std::vector<std::byte> memory_;
  Renderer<Traits> renderer_;
  OwnedMesh owned_ = tetrahedron();
  Mesh mesh_ = owned_.view();
  Transform transform_;
};

template <class Traits>
class Filling : public ::testing::Test {};
using AllTraits =
    ::testing::Types<FlatTraits<Rgb565, Depth16<>>, FlatTraits<Rgb565, Depth24<>>,
                     FlatTraits<Rgb565, Depth16<>, BoundedZBuffer>, FlatTraits<Rgb565, Depth16<>, Deferred<>>>;
TYPED_TEST_SUITE(Filling, AllTraits);

TYPED_TEST(Filling, GivesTheSameBytesWheneverTheHardwareDoesItsWork) {
  constexpr Rgb888 backgrounds[] = {{0, 0, 0}, {200, 100, 40}};
  Kept wanted;
  Frames<TypeParam> reference(capacity_of(1));
  for (const Rgb888 background : backgrounds)
    ASSERT_TRUE(reference.show([&](const auto& band) { return wanted.take(band); }, false, background).ok());

  for (const std::uint8_t depth_bands : {std::uint8_t{1}, std::uint8_t{2}})
    for (const bool late : {false, true})
      for (const bool runs_ahead : {false, true})
        for (const bool begin_early : {false, true}) {
          Frames<TypeParam> frames(capacity_of(depth_bands));
          LateSink sink;
          sink.late = late;
          sink.runs_ahead = runs_ahead;
          for (const Rgb888 background : backgrounds) ASSERT_TRUE(frames.show(sink, begin_early, background).ok());
          EXPECT_EQ(sink.kept.bands, wanted.bands) << int{depth_bands} << late << runs_ahead << begin_early;
          const bool clears_ahead = runs_ahead && depth_bands == 2 && BandDrawer<TypeParam>::Visibility::clears_ahead;
          EXPECT_EQ(sink.fills_while_drawing > 0, clears_ahead);
        }
}

TYPED_TEST(Filling, AFrameThatIsGivenUpLeavesNothingToTheNext) {
  LateSink wanted;
  ASSERT_TRUE(Frames<TypeParam>(capacity_of(2)).show(wanted, true, {1, 2, 3}).ok());
  for (std::size_t wait = 0; wait < wanted.kept.bands.size(); ++wait) {
    Frames<TypeParam> frames(capacity_of(2));
    LateSink failing, next;
    failing.waits_to_fail = wait;
    EXPECT_EQ(frames.show(failing, true, {90, 90, 90}).fault, Fault::sink_failed);
    EXPECT_EQ(failing.kept.bands.size(), wait);
    ASSERT_TRUE(frames.show(next, false, {1, 2, 3}).ok());
    EXPECT_EQ(next.kept.bands, wanted.kept.bands);
  }
}

}  // namespace
}  // namespace spanline::test
