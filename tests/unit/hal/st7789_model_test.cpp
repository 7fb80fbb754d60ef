#include "panels/st7789_model.hpp"

#include <array>

#include "model_fixture.hpp"

namespace spanline {
namespace {

using sim::ComplaintKind;

class St7789ModelTest : public test::ModelTest<sim::St7789Model> {
 protected:
  St7789ModelTest() : ModelTest(sim::St7789Glass::size_135x240, hal::Orientation::portrait) {}

  void set(std::uint8_t value, std::initializer_list<int> arguments) {
    command(value);
    data(arguments);
  }
  /// Reset, awake, on behind a black picture, inversion as the glass wants it.
  void wake() {
    reset();
    command(0x11);
    wait(120 * ms);
    set(0x2A, {0, 52, 0, 186});
    set(0x2B, {0, 40, 1, 23});
    command(0x2C);
    blank(3 * 135 * 240);
    command(0x29);
    command(0x21);
  }
  [[nodiscard]] std::array<int, 3> pixel(int x, int y) const {
    const sim::PanelPicture picture = model_.picture();
    const std::uint8_t* rgb = picture.at(x, y);
    return {rgb[0], rgb[1], rgb[2]};
  }
};

TEST_F(St7789ModelTest, ShowsTheMiddleOfTheMemory) {
  wake();
  set(0x3A, {0x55});
  set(0x2A, {0, 52, 0, 52});
  set(0x2B, {0, 40, 0, 40});
  set(0x2C, {0xF8, 0x00});
  EXPECT_EQ(pixel(0, 0), (std::array{255, 0, 0}));
  EXPECT_EQ(model_.written_beside_the_glass(), 0U);
  set(0x2A, {0, 51, 0, 51});
  set(0x2C, {0xF8, 0x00});
  EXPECT_EQ(model_.written_beside_the_glass(), 1U);
  EXPECT_TRUE(complaints().empty());
}

TEST_F(St7789ModelTest, WithoutInversionColoursAreComplements) {
  wake();
  command(0x20);
  set(0x3A, {0x55});
  set(0x2A, {0, 52, 0, 52});
  set(0x2B, {0, 40, 0, 40});
  set(0x2C, {0xF8, 0x00});
  EXPECT_EQ(pixel(0, 0), (std::array{0, 255, 255}));
}

TEST_F(St7789ModelTest, TakesTwelveBitsInPairs) {
  wake();
  set(0x3A, {0x53});
  set(0x2A, {0, 52, 0, 53});
  set(0x2B, {0, 40, 0, 40});
  set(0x2C, {0x12, 0x34, 0x56});
  EXPECT_EQ(pixel(0, 0), (std::array{0x11, 0x22, 0x33}));
  EXPECT_EQ(pixel(1, 0), (std::array{0x44, 0x55, 0x66}));
  EXPECT_TRUE(complaints().empty());
  set(0x2C, {0x12, 0x34});
  model_.end_of_stream();
  expect_only(ComplaintKind::partial_pixel);
}

TEST_F(St7789ModelTest, TakesEighteenBitsAndRefusesOtherFormats) {
  wake();
  set(0x3A, {0x66});
  set(0x2A, {0, 52, 0, 52});
  set(0x2B, {0, 40, 0, 40});
  set(0x2C, {0xFC, 0x00, 0x80});
  EXPECT_EQ(pixel(0, 0), (std::array{255, 0, 130}));
  EXPECT_TRUE(complaints().empty());
  set(0x3A, {0x57});
  expect_only(ComplaintKind::wrong_setup);
}

TEST_F(St7789ModelTest, KnowsItsOwnCommands) {
  wake();
  set(0xB2, {0x0C, 0x0C, 0x00, 0x33, 0x33});
  set(0xD0, {0xA4, 0xA1});
  EXPECT_TRUE(complaints().empty());
  command(0xCF);  // the ILI9341's power control B
  expect_only(ComplaintKind::unknown_command);
}

TEST_F(St7789ModelTest, WarnsAboveTheRatedClockAndFailsAboveTheTolerated) {
  model_.set_clock(62'500'000, now_ns_);
  EXPECT_TRUE(complaints().empty());
  model_.set_clock(75'000'000, now_ns_);
  expect_only(ComplaintKind::clock_above_rating);
  EXPECT_FALSE(any_failure(model_.complaints()));
  model_.set_clock(90'000'000, now_ns_);
  EXPECT_TRUE(any_failure(model_.complaints()));
}

TEST_F(St7789ModelTest, SaysWhoItIs) {
  reset();
  EXPECT_EQ(model_.read(0x04, now_ns_), (std::vector<std::uint8_t>{0x00, 0x85, 0x85, 0x52}));
  EXPECT_TRUE(complaints().empty());
  EXPECT_TRUE(model_.read(0x09, now_ns_).empty());
  expect_only(ComplaintKind::not_modelled);
}

TEST_F(St7789ModelTest, ComplainsOfPixelsInItsSleep) {
  reset();
  set(0x3A, {0x55});
  set(0x2C, {0, 0});
  expect_only(ComplaintKind::write_during_sleep);
}

}  // namespace
}  // namespace spanline
