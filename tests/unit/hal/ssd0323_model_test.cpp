#include "panels/ssd0323_model.hpp"

#include "model_fixture.hpp"

namespace spanline {
namespace {

using sim::ComplaintKind;

class Ssd0323ModelTest : public test::ModelTest<sim::Ssd0323Model> {
 protected:
  void commands(std::initializer_list<int> values) {
    for (const int value : values) command(static_cast<std::uint8_t>(value));
  }
  /// Reset, set up for the glass, on behind a black picture.
  void wake() {
    reset();
    commands({0xA8, 0x3F, 0xA2, 0x40, 0xA1, 0x00, 0xA0, 0x52, 0xA4});
    blank(64 * 80);
    commands({0x15, 0, 63, 0x75, 0, 79, 0xAF});
  }
  [[nodiscard]] int grey(int x, int y) const {
    const sim::PanelPicture picture = model_.picture();
    const std::uint8_t* pixel = picture.at(x, y);
    EXPECT_EQ(pixel[0], pixel[1]);
    EXPECT_EQ(pixel[0], pixel[2]);
    return pixel[0];
  }
};

TEST_F(Ssd0323ModelTest, AcceptsAProperSequence) {
  wake();
  commands({0x15, 5, 5, 0x75, 7, 8});
  data({0x1F, 0x20});
  model_.end_of_stream();
  EXPECT_TRUE(complaints().empty());
  EXPECT_EQ(grey(10, 7), 17);
  EXPECT_EQ(grey(11, 7), 255);
  EXPECT_EQ(grey(10, 8), 34);
  EXPECT_EQ(grey(11, 8), 0);
}

TEST_F(Ssd0323ModelTest, WantsAReset) {
  command(0xAE);
  expect_only(ComplaintKind::missing_reset);
}

TEST_F(Ssd0323ModelTest, WantsALongEnoughResetAndAPause) {
  reset(2 * us, 50 * us);
  command(0xAE);
  EXPECT_EQ(complaints(), (std::vector<std::string>{"reset_too_short", "missing_delay"}));
}

TEST_F(Ssd0323ModelTest, WantsAPictureBeforeTheDisplayGoesOn) {
  wake();
  EXPECT_TRUE(complaints().empty());
  reset();
  command(0xAF);
  expect_only(ComplaintKind::shown_before_picture);
}

TEST_F(Ssd0323ModelTest, KnowsItsCommands) {
  wake();
  command(0x23);
  expect_only(ComplaintKind::unknown_command);
}

TEST_F(Ssd0323ModelTest, WantsWindowsInsideAndForward) {
  wake();
  commands({0x15, 0, 64});
  commands({0x75, 0, 80});
  commands({0x75, 3, 2});
  expect_only(ComplaintKind::window_out_of_range);
  EXPECT_EQ(model_.complaints().front().count, 3U);
}

TEST_F(Ssd0323ModelTest, DataEndsACommandThatWantsMore) {
  wake();
  commands({0x15, 0});
  data({0});
  expect_only(ComplaintKind::wrong_argument_count);
}

TEST_F(Ssd0323ModelTest, CountsArgumentsAtTheEnd) {
  wake();
  commands({0xB8, 1, 2, 3});
  model_.end_of_stream();
  expect_only(ComplaintKind::wrong_argument_count);
}

TEST_F(Ssd0323ModelTest, WrapsInsideTheWindowWithAWarning) {
  wake();
  commands({0x15, 0, 0, 0x75, 0, 0});
  data({0x11});
  EXPECT_TRUE(complaints().empty());
  data({0x22});
  expect_only(ComplaintKind::more_pixels_than_window);
  EXPECT_FALSE(any_failure(model_.complaints()));
  EXPECT_EQ(grey(0, 0), 34);
}

TEST_F(Ssd0323ModelTest, WantsASetupThatSuitsTheGlass) {
  reset();
  commands({0xA0, 0x52});
  data({0});
  expect_only(ComplaintKind::wrong_setup);
}

TEST_F(Ssd0323ModelTest, KnowsNibbleOrderAndDirection) {
  wake();
  commands({0xA0, 0x50, 0x15, 0, 1, 0x75, 0, 1});
  data({0x1F});
  EXPECT_EQ(grey(0, 0), 255);
  EXPECT_EQ(grey(1, 0), 17);
  commands({0xA0, 0x56, 0x15, 0, 1, 0x75, 0, 1});
  data({0x11, 0x22, 0x33, 0x44});
  EXPECT_EQ(grey(0, 0), 17);
  EXPECT_EQ(grey(0, 1), 34);
  EXPECT_EQ(grey(2, 0), 51);
  EXPECT_EQ(grey(2, 1), 68);
  EXPECT_TRUE(complaints().empty());
}

TEST_F(Ssd0323ModelTest, ShowsItsModes) {
  wake();
  commands({0x15, 0, 63, 0x75, 0, 63});
  data({0x50});
  command(0xA5);
  EXPECT_EQ(grey(0, 0), 255);
  command(0xA6);
  EXPECT_EQ(grey(0, 0), 0);
  command(0xA7);
  EXPECT_EQ(grey(0, 0), 170);
  command(0xA4);
  EXPECT_EQ(grey(0, 0), 85);
  command(0xAE);
  EXPECT_EQ(grey(0, 0), 0);
}

TEST_F(Ssd0323ModelTest, ChecksTheBusClock) {
  model_.set_clock(4'000'000, 0);
  EXPECT_TRUE(complaints().empty());
  model_.set_clock(4'000'001, 0);
  expect_only(ComplaintKind::clock_too_high);
}

}  // namespace
}  // namespace spanline
