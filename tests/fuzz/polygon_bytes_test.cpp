// What the fuzzer does, without a fuzzer: any bytes are a polygon table that all exact algorithms draw alike. A failure
// shrinks to a few bytes.
#include "polygon_bytes.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "generators.hpp"
#include "support/effort.hpp"

namespace spanline::fuzz {
namespace {

TEST(PolygonBytes, ScenesComeBackAsTheyWere) {
  test::Random random(3);
  contract::Scene scene = contract::mixed_soup(random);
  scene.width = 70;
  scene.height = 50;
  const Case drawn = decode(encode(scene, 7, 9));
  EXPECT_EQ(drawn.scene.width, 70);
  EXPECT_EQ(drawn.scene.height, 50);
  EXPECT_EQ(drawn.manner.band_lines, 7);
  EXPECT_EQ(drawn.active, 9);
  ASSERT_EQ(drawn.scene.triangles.size(), scene.triangles.size());
  for (std::size_t i = 0; i < scene.triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const contract::Corner &want = scene.triangles[i][k], &got = drawn.scene.triangles[i][k];
      EXPECT_TRUE(want.x == got.x && want.y == got.y && want.z == got.z);
    }
}

TEST(PolygonBytes, EveryOpcodeMakesATriangle) {
  const std::uint8_t bytes[] = {9,  9,  0,  0,    0,                      // 10 × 10
                                1,  64, 64, 1,    74, 64, 1, 64, 74, 2,   // pixels, from −64
                                13, 64, 64, 1,    74, 64, 1, 64, 74, 2,   // on centres
                                2,  0,  1,  0xff, 3,  1,  1,              // the first, corner 1 moved
                                3,  1,  2,  16,   0,  32, 0, 3,  0,  1};  // an edge of the second
  const Case drawn = decode(bytes);
  ASSERT_EQ(drawn.scene.triangles.size(), 4U);
  const auto expect = [&](std::size_t triangle, std::size_t corner, int x, int y, std::int32_t z) {
    const contract::Corner& c = drawn.scene.triangles[triangle][corner];
    EXPECT_EQ(c.x, x);
    EXPECT_EQ(c.y, y);
    EXPECT_EQ(c.z, z);
  };
  expect(0, 1, 160, 0, 1 << 16);
  expect(1, 1, 168, 8, 1 << 16);
  expect(2, 0, 0, 0, 1 << 16);
  expect(2, 1, 159, 3, (1 << 16) + 257);
  expect(3, 2, 16, 32, (1 << 16) + 3);
}

RC_GTEST_PROP(PolygonBytes, AnyBytesAreDrawnAlikeByAllExactAlgorithms, (const std::vector<std::uint8_t>& bytes)) {
  RC_ASSERT(fault_in(decode(bytes)) == "");
}

TEST(PolygonBytes, LongRandomTablesAreDrawnAlikeByAllExactAlgorithms) {
  test::Random random(11);
  for (int i = 0; i < test::rounds(400); ++i) {
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(random.between(5, 1500)));
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.between(0, 255));
    ASSERT_EQ(fault_in(decode(bytes)), "") << "round " << i;
  }
}

}  // namespace
}  // namespace spanline::fuzz
