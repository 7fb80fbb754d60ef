// The turntable's loop on this host: through both drivers into the panels' models, and over a bus that sticks.
#include <gtest/gtest.h>

#include <bunny.hpp>
#include <cstdint>
#include <vector>

#include "apps/turntable.hpp"
#include "panels/fake_buses.hpp"
#include "panels/ili9341_model.hpp"
#include "panels/ssd0323_model.hpp"
#include "spanline/hal/panels/ili9341.hpp"
#include "spanline/hal/panels/ssd0323.hpp"

namespace spanline {
namespace {

using sim::HostBus;
using sim::SimClock;
using sim::StuckBus;

template <class Bus>
using Oled = hal::Ssd0323<Bus, SimClock>;
template <class Bus>
using Tft = hal::Ili9341<Bus, SimClock>;

sim::Ssd0323Model model_for(const Oled<StuckBus>*) { return {}; }
sim::Ili9341Model model_for(const Tft<StuckBus>*) { return sim::Ili9341Model(hal::Orientation::landscape); }

/// The pools of firmware/apps/turntable.cpp.
template <class Panel>
constexpr Capacity app_capacity = apps::Turntable<Panel, SimClock>::capacity(spanline_models::bunny, 8, 2, 1700, 100);

/// An app with its panel, over a bus that can be made to stick.
template <class Panel>
struct Bench {
  using App = apps::Turntable<Panel, SimClock>;

  SimClock clock;
  decltype(model_for(static_cast<const Panel*>(nullptr))) model = model_for(static_cast<const Panel*>(nullptr));
  HostBus wires{model, clock, Panel::clock_rating.rated_hz};
  StuckBus bus{wires};
  Panel panel{bus, clock};
  std::vector<std::uint64_t> memory =
      std::vector<std::uint64_t>(App::Picture::bytes_needed(app_capacity<Panel>) / sizeof(std::uint64_t) + 1);
  App app{panel, clock, spanline_models::bunny, app_capacity<Panel>, std::as_writable_bytes(std::span(memory))};
};

template <class Panel>
class Turntable : public testing::Test {};
using Panels = testing::Types<Oled<StuckBus>, Tft<StuckBus>>;
TYPED_TEST_SUITE(Turntable, Panels);

TYPED_TEST(Turntable, EveryFrameOfATurnFitsThePoolsAndReachesThePanel) {
  Bench<TypeParam> bench;
  for (std::uint32_t frame = 0; frame < Bench<TypeParam>::App::frames_a_turn; ++frame) {
    const auto result = bench.app.show(frame);
    EXPECT_EQ(result.display, hal::DisplayStatus::ok) << "frame " << frame;
    EXPECT_EQ(result.drawing.fault, Fault::none)
        << "frame " << frame << ": " << to_string(result.drawing.pool) << ", wanted " << result.drawing.wanted;
  }
  EXPECT_EQ(bench.app.statistics().frames, 60U);
  EXPECT_EQ(bench.app.statistics().initialisations, 1U);
  for (const sim::Complaint& complaint : bench.model.complaints()) ADD_FAILURE() << describe(complaint);
}

TYPED_TEST(Turntable, TheModelTurns) {
  Bench<TypeParam> bench;
  EXPECT_TRUE(bench.app.show(0).ok());
  const std::vector<std::uint8_t> first = bench.model.picture().rgb;
  EXPECT_TRUE(bench.app.show(15).ok());
  EXPECT_NE(bench.model.picture().rgb, first);
  EXPECT_TRUE(bench.app.show(60).ok());
  EXPECT_EQ(bench.model.picture().rgb, first);
}

TYPED_TEST(Turntable, ABusThatSticksCostsAFrameAndTheNextOneInitialisesThePanelAnew) {
  Bench<TypeParam> good, bench;
  EXPECT_TRUE(bench.app.show(0).ok());
  bench.bus.stick_at(3);
  EXPECT_EQ(bench.app.show(1).display, hal::DisplayStatus::bus_timeout);
  EXPECT_EQ(bench.app.show(2).display, hal::DisplayStatus::bus_timeout) << "still stuck";
  bench.bus.recover();
  EXPECT_TRUE(bench.app.show(3).ok());
  EXPECT_EQ(bench.app.statistics().initialisations, 2U);
  EXPECT_EQ(bench.app.statistics().frames_given_up, 2U);
  EXPECT_TRUE(good.app.show(3).ok());
  EXPECT_EQ(bench.model.picture().rgb, good.model.picture().rgb);
}

TYPED_TEST(Turntable, APoolThatIsTooSmallIsNamedAndWhatFitsIsShown) {
  Bench<TypeParam> bench;
  Capacity tight = app_capacity<TypeParam>;
  tight.polygons = 300;
  std::vector<std::uint64_t> memory(Bench<TypeParam>::App::Picture::bytes_needed(tight) / sizeof(std::uint64_t) + 1);
  typename Bench<TypeParam>::App app(bench.panel, bench.clock, spanline_models::bunny, tight,
                                     std::as_writable_bytes(std::span(memory)));
  const auto result = app.show(0);
  EXPECT_EQ(result.display, hal::DisplayStatus::ok);
  EXPECT_EQ(result.drawing.fault, Fault::pool_full);
  EXPECT_EQ(result.drawing.pool, Pool::polygons);
  EXPECT_GT(result.drawing.wanted, 300U);
}

TYPED_TEST(Turntable, MemoryThatIsTooSmallIsAStatus) {
  Bench<TypeParam> bench;
  std::vector<std::byte> memory(100);
  typename Bench<TypeParam>::App app(bench.panel, bench.clock, spanline_models::bunny, app_capacity<TypeParam>, memory);
  const auto result = app.show(0);
  EXPECT_EQ(result.drawing.fault, Fault::pool_full);
  EXPECT_EQ(result.drawing.pool, Pool::memory);
}

}  // namespace
}  // namespace spanline
