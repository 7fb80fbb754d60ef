// The claim of small_triangle.hpp: its fixed-point edges are exact for every slope, start and row.
#include <gtest/gtest.h>

#include "spanline/raster/small_triangle.hpp"
#include "support/effort.hpp"
#include "support/exact_triangle.hpp"
#include "support/random.hpp"
#include "support/studio.hpp"

namespace spanline::test {
namespace {

/// ⌈(X − 8) / 16⌉ with X = x0 + s·dx/dy: the first pixel whose centre lies at or right of the edge, s sixteenths below
/// its start.
int exact_column(int x0, int dx, int dy, int s) {
  const int numerator = (x0 - 8) * dy + s * dx, denominator = 16 * dy;
  return numerator >= 0 ? (numerator + denominator - 1) / denominator : -(-numerator / denominator);
}

/// Counts rows at which the walked column differs; rows down to `last` sixteenths below the start.
int wrong_rows(std::uint32_t edge, std::uint32_t step, int x0, int dx, int dy, int offset, int last) {
  int wrong = 0;
  for (int s = offset; s < last; s += 16, edge += step) {
    // Columns count from the top vertex's pixel, moved by the margin, and wrap at 64.
    const int column = static_cast<int>(small_triangle::column(edge)) - small_triangle::margin;
    wrong += ((column - exact_column(x0, dx, dy, s)) & 63) != 0;
  }
  return wrong;
}

Triangle triangle(int sub_pixel, int dx1, int dy1, int dx2, int dy2) {
  Triangle t{};
  t.ax = ScreenVertex::bias + sub_pixel;
  t.ay = ScreenVertex::bias;
  t.dx1 = dx1;
  t.dy1 = dy1;
  t.dx2 = dx2;
  t.dy2 = dy2;
  return t;
}

TEST(SmallEdges, EdgesFromTheTopVertexAreExactForEverySlopeStartAndRow) {
  long rows = 0, wrong = 0;
  for (int dx = -small_triangle::reach; dx <= small_triangle::reach; dx += static_cast<int>(stride(3)))
    for (int dy = 1; dy <= small_triangle::max_height; ++dy)
      for (int sub_pixel = 0; sub_pixel < 16; ++sub_pixel)
        for (int offset = 0; offset < 16 && offset < dy; ++offset) {
          small_triangle::Edges edges{};
          small_triangle::set_edges(triangle(sub_pixel, dx, dy, dx, dy), offset, 0, edges);
          wrong += wrong_rows(edges.left, edges.left_step, sub_pixel, dx, dy, offset, dy);
          wrong += wrong_rows(edges.right, edges.right_step, sub_pixel, dx, dy, offset, dy);
          rows += 2 * ((dy - offset + 15) / 16);
        }
  EXPECT_EQ(wrong, 0) << "of " << rows << " rows";
  std::printf("%ld rows of edges from the top\n", rows);
}

TEST(SmallEdges, ThirdEdgesAreExactForEverySlopeStartAndRow) {
  // From b at (dx1, 1) on the right, or its mirror image on the left; the sub-pixel start comes with the top vertex.
  long rows = 0, wrong = 0;
  for (int dx = -2 * small_triangle::reach; dx <= 2 * small_triangle::reach; dx += static_cast<int>(stride(5)))
    for (int dy = 1; dy < small_triangle::max_height; ++dy)
      for (int sub_pixel = 0; sub_pixel < 16; ++sub_pixel)
        for (int offset = 0; offset < 16 && offset < dy; ++offset) {
          const int start = dx > 0 ? -(dx / 2) : (-dx + 1) / 2;
          const int end = start + dx;
          const int x0 = sub_pixel + start;
          small_triangle::Edges edges{};
          small_triangle::set_edges(triangle(sub_pixel, start, 1, end, 1 + dy), 0, offset, edges);
          wrong += wrong_rows(edges.bend, edges.bend_step, x0, dx, dy, offset, dy);
          small_triangle::set_edges(triangle(sub_pixel, end, 1 + dy, start, 1), 0, offset, edges);
          wrong += wrong_rows(edges.bend, edges.bend_step, x0, dx, dy, offset, dy);
          rows += 2 * ((dy - offset + 15) / 16);
        }
  EXPECT_EQ(wrong, 0) << "of " << rows << " rows";
  std::printf("%ld rows of third edges\n", rows);
}

// The same through the renderer: every dx and dy of an edge as the left and as the right side of a drawn triangle.
TEST(SmallEdges, EverySlopeDrawsExactlyTheRightPixels) {
  Studio<FlatTraits<Rgb565, Depth16<>>> studio(screen_capacity(40, 40, 1));
  Random random(3);
  long pixels = 0;
  for (int dx = -128; dx <= 128; dx += static_cast<int>(stride(8)))
    for (int dy = 1; dy <= 255; ++dy) {
      const int x = 320 + random.between(0, 15), y = 64 + random.between(0, 15), other = random.between(-128, 128),
                other_dy = random.between(0, 255);
      const Corners corners{Corner{x, y, 100}, Corner{x + dx, y + dy, 200}, Corner{x + other, y + other_dy, 300}};
      const auto picture = studio.draw_screen({&corners, 1});
      std::size_t covered = 0, missing = 0;
      ExactTriangle(corners).for_each_pixel(40, 40, [&](int px, int py) {
        ++covered;
        missing += picture.drawn(px, py) ? 0U : 1U;
      });
      ASSERT_TRUE(missing == 0 && picture.drawn_count() == covered) << corners;
      pixels += static_cast<long>(covered);
    }
  std::printf("%ld pixels\n", pixels);
}

}  // namespace
}  // namespace spanline::test
