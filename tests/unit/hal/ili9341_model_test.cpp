#include "panels/ili9341_model.hpp"

#include <array>

#include "model_fixture.hpp"
#include "panels/host_bus.hpp"

namespace spanline {
namespace {

using sim::ComplaintKind;

class Ili9341ModelTest : public test::ModelTest<sim::Ili9341Model> {
 protected:
  Ili9341ModelTest() : ModelTest(hal::Orientation::portrait) {}

  void set(std::uint8_t value, std::initializer_list<int> arguments) {
    command(value);
    data(arguments);
  }
  void window(int x0, int x1, int y0, int y1) {
    set(0x2A, {x0 >> 8, x0 & 255, x1 >> 8, x1 & 255});
    set(0x2B, {y0 >> 8, y0 & 255, y1 >> 8, y1 & 255});
  }
  /// Reset, awake, 16 bits a pixel, upright.
  void wake_dark() {
    reset();
    command(0x11);
    wait(120 * ms);
    set(0x3A, {0x55});
    set(0x36, {0x48});
  }
  /// The same, on behind a black picture.
  void wake() {
    wake_dark();
    command(0x2C);
    blank(2 * 240 * 320);
    command(0x29);
  }
  void expect_pixel(int x, int y, std::array<int, 3> want) const {
    const sim::PanelPicture picture = model_.picture();
    const std::uint8_t* pixel = picture.at(x, y);
    EXPECT_EQ((std::array<int, 3>{pixel[0], pixel[1], pixel[2]}), want) << x << ", " << y;
  }
};

TEST_F(Ili9341ModelTest, AcceptsAProperSequence) {
  wake();
  window(10, 11, 20, 20);
  set(0x2C, {0xF8, 0x00, 0x07, 0xE0});
  model_.end_of_stream();
  EXPECT_TRUE(complaints().empty());
  expect_pixel(10, 20, {255, 0, 0});
  expect_pixel(11, 20, {0, 255, 0});
}

TEST_F(Ili9341ModelTest, WantsAReset) {
  command(0x13);
  expect_only(ComplaintKind::missing_reset);
}

TEST_F(Ili9341ModelTest, TakesASoftwareResetForAReset) {
  command(0x01);
  wait(120 * ms);
  command(0x11);
  EXPECT_TRUE(complaints().empty());
}

TEST_F(Ili9341ModelTest, WantsALongEnoughReset) {
  reset(9 * us);
  expect_only(ComplaintKind::reset_too_short);
}

TEST_F(Ili9341ModelTest, WantsAPauseAfterReset) {
  reset(10 * us, 100 * ms);
  command(0x11);
  expect_only(ComplaintKind::missing_delay);
}

TEST_F(Ili9341ModelTest, WantsAPauseAfterSoftwareReset) {
  reset();
  command(0x01);
  wait(100 * ms);
  command(0x11);
  expect_only(ComplaintKind::missing_delay);
}

TEST_F(Ili9341ModelTest, WantsAPauseAfterSleepOut) {
  reset();
  command(0x11);
  wait(5 * ms);
  command(0x13);
  expect_only(ComplaintKind::missing_delay);
}

TEST_F(Ili9341ModelTest, WantsAPauseAfterSleepIn) {
  wake();
  command(0x10);
  command(0x11);
  expect_only(ComplaintKind::missing_delay);
}

TEST_F(Ili9341ModelTest, TakesNothingDuringReset) {
  model_.reset_line(true, now_ns_);
  command(0x11);
  expect_only(ComplaintKind::byte_during_reset);
}

TEST_F(Ili9341ModelTest, KnowsItsCommands) {
  wake();
  set(0xAB, {1, 2, 3});
  expect_only(ComplaintKind::unknown_command);
}

TEST_F(Ili9341ModelTest, CountsTooFewArguments) {
  wake();
  set(0x2A, {0, 0, 0});
  command(0x00);
  expect_only(ComplaintKind::wrong_argument_count);
}

TEST_F(Ili9341ModelTest, CountsTooFewArgumentsAtTheEnd) {
  wake();
  set(0xB1, {0});
  model_.end_of_stream();
  expect_only(ComplaintKind::wrong_argument_count);
}

TEST_F(Ili9341ModelTest, CountsTooManyArguments) {
  wake();
  set(0x3A, {0x55, 0x55});
  expect_only(ComplaintKind::wrong_argument_count);
}

TEST_F(Ili9341ModelTest, ACommandWithoutArgumentsTakesNone) {
  wake();
  set(0x29, {0});
  expect_only(ComplaintKind::wrong_argument_count);
}

TEST_F(Ili9341ModelTest, WantsACommandBeforeData) {
  reset();
  data({1});
  expect_only(ComplaintKind::data_without_command);
}

TEST_F(Ili9341ModelTest, WantsWindowsInside) {
  wake();
  set(0x2A, {0, 0, 0, 240});
  expect_only(ComplaintKind::window_out_of_range);
}

TEST_F(Ili9341ModelTest, WantsWindowsForward) {
  wake();
  set(0x2B, {0, 9, 0, 8});
  expect_only(ComplaintKind::window_out_of_range);
}

TEST_F(Ili9341ModelTest, TurnsTheLimitsWithTheAddresses) {
  wake();
  set(0x36, {0x28});
  window(0, 319, 0, 239);
  EXPECT_TRUE(complaints().empty());
  window(0, 319, 0, 240);
  expect_only(ComplaintKind::window_out_of_range);
}

TEST_F(Ili9341ModelTest, AWindowThatNoLongerFitsIsNotWritten) {
  wake();  // the window after reset is 240 × 320
  set(0x36, {0x28});
  set(0x2C, {0xFF, 0xFF});
  expect_only(ComplaintKind::window_out_of_range);
}

TEST_F(Ili9341ModelTest, WantsToBeAwakeForPixels) {
  reset();
  set(0x3A, {0x55});
  set(0x2C, {0, 0});
  expect_only(ComplaintKind::write_during_sleep);
}

TEST_F(Ili9341ModelTest, WrapsInsideTheWindowWithAWarning) {
  wake();
  window(0, 1, 0, 0);
  set(0x2C, {0xF8, 0x00, 0xF8, 0x00});
  EXPECT_TRUE(complaints().empty());
  data({0x00, 0x1F});
  expect_only(ComplaintKind::more_pixels_than_window);
  EXPECT_FALSE(any_failure(model_.complaints()));
  expect_pixel(0, 0, {0, 0, 255});
  expect_pixel(1, 0, {255, 0, 0});
}

TEST_F(Ili9341ModelTest, ContinuesAWrite) {
  wake();
  window(0, 3, 0, 0);
  set(0x2C, {0xF8, 0x00});
  set(0x3C, {0x07, 0xE0});
  EXPECT_TRUE(complaints().empty());
  expect_pixel(0, 0, {255, 0, 0});
  expect_pixel(1, 0, {0, 255, 0});
}

TEST_F(Ili9341ModelTest, WantsWholePixels) {
  wake();
  set(0x2C, {0xF8, 0x00, 0xF8});
  model_.end_of_stream();
  expect_only(ComplaintKind::partial_pixel);
}

TEST_F(Ili9341ModelTest, StartsWith18BitsAPixel) {
  reset();
  command(0x11);
  wait(120 * ms);
  set(0x36, {0x48});
  command(0x2C);
  blank(3 * 240 * 320);
  command(0x29);
  set(0x2C, {0xFC, 0x80, 0x00});
  expect_pixel(0, 0, {255, 130, 0});
}

TEST_F(Ili9341ModelTest, KnowsTheGlassFilters) {
  wake();
  set(0x36, {0x40});  // without BGR
  set(0x2C, {0xF8, 0x00});
  expect_pixel(0, 0, {0, 0, 255});
}

TEST_F(Ili9341ModelTest, ShowsMirroredAddressesMirrored) {
  wake();
  set(0x36, {0x08});  // without MX
  set(0x2C, {0xF8, 0x00});
  expect_pixel(239, 0, {255, 0, 0});
  set(0x36, {0xC8});
  set(0x2C, {0x07, 0xE0});
  expect_pixel(0, 319, {0, 255, 0});
}

TEST_F(Ili9341ModelTest, RefusesOtherPixelFormats) {
  wake();
  set(0x3A, {0x53});
  expect_only(ComplaintKind::wrong_setup);
}

TEST_F(Ili9341ModelTest, SaysWhatItDoesNotShow) {
  wake();
  set(0x37, {0, 0});
  EXPECT_TRUE(complaints().empty());
  set(0x37, {0, 7});
  expect_only(ComplaintKind::not_modelled);
  EXPECT_FALSE(any_failure(model_.complaints()));
}

TEST_F(Ili9341ModelTest, IsDarkWhileOffOrAsleepAndKeepsItsMemory) {
  wake();
  set(0x2C, {0xF8, 0x00});
  command(0x28);
  expect_pixel(0, 0, {0, 0, 0});
  command(0x10);
  wait(120 * ms);
  command(0x11);
  wait(120 * ms);
  command(0x29);
  expect_pixel(0, 0, {255, 0, 0});
  command(0x21);
  expect_pixel(0, 0, {0, 255, 255});
  EXPECT_TRUE(complaints().empty());
}

TEST_F(Ili9341ModelTest, WantsAPictureBeforeTheDisplayGoesOn) {
  wake_dark();
  command(0x2C);
  blank(2 * (240 * 320 - 1));
  command(0x29);
  expect_only(ComplaintKind::shown_before_picture);
  EXPECT_TRUE(any_failure(model_.complaints()));
}

TEST_F(Ili9341ModelTest, WantsAPictureAgainAfterAReset) {
  wake();
  wake_dark();
  command(0x29);
  expect_only(ComplaintKind::shown_before_picture);
}

TEST_F(Ili9341ModelTest, WantsTheDisplayOnBeforeTheBacklight) {
  wake_dark();
  command(0x2C);
  blank(2 * 240 * 320);
  model_.backlight_line(false, now_ns_);
  EXPECT_TRUE(complaints().empty());
  model_.backlight_line(true, now_ns_);
  expect_only(ComplaintKind::shown_before_picture);
}

TEST_F(Ili9341ModelTest, IsDarkWithoutItsBacklight) {
  wake();
  set(0x2C, {0xF8, 0x00});
  model_.backlight_line(false, now_ns_);
  expect_pixel(0, 0, {0, 0, 0});
  model_.backlight_line(true, now_ns_);
  expect_pixel(0, 0, {255, 0, 0});
  EXPECT_TRUE(complaints().empty());
}

TEST_F(Ili9341ModelTest, WantsNoResetInFullLight) {
  wake();
  model_.backlight_line(true, now_ns_);
  EXPECT_TRUE(complaints().empty());
  reset();
  expect_only(ComplaintKind::shown_before_picture);
}

TEST_F(Ili9341ModelTest, ForgetsEverythingWithItsPower) {
  wake();
  set(0x2C, {0xF8, 0x00});
  model_.lose_power(now_ns_);
  expect_pixel(0, 0, {0, 0, 0});
  set(0x2C, {0xF8, 0x00});
  EXPECT_EQ(complaints(), (std::vector<std::string>{"write_during_sleep", "missing_reset"}));
}

TEST_F(Ili9341ModelTest, ChecksTheBusClock) {
  model_.set_clock(10'000'000, 0);
  EXPECT_TRUE(complaints().empty());
  model_.set_clock(40'000'000, 0);
  expect_only(ComplaintKind::clock_above_rating);
  EXPECT_FALSE(any_failure(model_.complaints()));
  model_.clear_complaints();
  model_.set_clock(40'000'001, 0);
  expect_only(ComplaintKind::clock_too_high);
  EXPECT_TRUE(any_failure(model_.complaints()));
}

TEST_F(Ili9341ModelTest, DescribesAComplaintInOneLine) {
  wake();
  set(0xAB, {});
  set(0xAC, {});
  EXPECT_EQ(describe(model_.complaints().front()).substr(0, 43), "failure: unknown_command: command 0xAB (at ");
  EXPECT_EQ(model_.complaints().front().count, 2U);
}

class HostBusTest : public ::testing::Test {
 protected:
  sim::SimClock clock_;
  sim::Ili9341Model model_{hal::Orientation::portrait};
  sim::HostBus bus_{model_, clock_, 8'000'000};
};

TEST_F(HostBusTest, TakesEightClocksAByte) {
  std::array<std::uint8_t, 100> pixels{};
  ASSERT_EQ(bus_.pixels(pixels), hal::DisplayStatus::ok);
  EXPECT_TRUE(bus_.busy());
  clock_.delay_us(99);
  EXPECT_TRUE(bus_.busy());
  clock_.delay_us(1);
  EXPECT_FALSE(bus_.busy());
}

TEST_F(HostBusTest, ComplainsOfCommandsDuringATransfer) {
  std::array<std::uint8_t, 100> pixels{};
  ASSERT_EQ(bus_.pixels(pixels), hal::DisplayStatus::ok);
  ASSERT_EQ(bus_.command(std::array<std::uint8_t, 1>{0x00}), hal::DisplayStatus::ok);
  ASSERT_FALSE(model_.complaints().empty());
  EXPECT_EQ(model_.complaints().front().kind, ComplaintKind::bus_used_while_busy);
}

TEST_F(HostBusTest, ComplainsOfABufferThatChangesInFlight) {
  std::array<std::uint8_t, 100> pixels{};
  ASSERT_EQ(bus_.pixels(pixels), hal::DisplayStatus::ok);
  pixels[99] = 1;
  clock_.delay_us(100);
  EXPECT_FALSE(bus_.busy());
  ASSERT_FALSE(model_.complaints().empty());
  EXPECT_EQ(model_.complaints().front().kind, ComplaintKind::buffer_changed_in_flight);
}

TEST_F(HostBusTest, ResetAbandonsATransfer) {
  std::array<std::uint8_t, 100> pixels{};
  ASSERT_EQ(bus_.pixels(pixels), hal::DisplayStatus::ok);
  bus_.reset(true);
  EXPECT_FALSE(bus_.busy());
}

}  // namespace
}  // namespace spanline
