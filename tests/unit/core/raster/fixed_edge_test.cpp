// The claims of small_triangle.hpp and medium_triangle.hpp: their fixed-point edges are exact for every slope, start
// and row.
#include <gtest/gtest.h>

#include "spanline/frame/ready_made_traits.hpp"
#include "spanline/raster/medium_triangle.hpp"
#include "spanline/raster/small_triangle.hpp"
#include "spanline/raster/surface_blocks.hpp"
#include "support/effort.hpp"
#include "support/exact_triangle.hpp"
#include "support/random.hpp"
#include "support/ready_made_studios.hpp"

namespace spanline::test {
namespace {

/// ⌈(X − 8) / 16⌉ with X = x0 + s·dx/dy: the first pixel whose centre lies at or right of the edge, s sixteenths below
/// its start.
int exact_column(int x0, int dx, int dy, int s) {
  const int numerator = (x0 - 8) * dy + s * dx, denominator = 16 * dy;
  return numerator >= 0 ? (numerator + denominator - 1) / denominator : -(-numerator / denominator);
}

/// An edge as a set-up function made it.
struct Walked {
  std::uint32_t column, step;
  int fraction_bits;
  int origin;  ///< what its columns count from, pixels from the column of x0
};

/// Counts rows, down to `height` sixteenths below the start, at which the walked column differs.
int wrong_rows(Walked edge, int x0, int dx, int dy, int offset) {
  int wrong = 0;
  const int wraps = 1 << (32 - edge.fraction_bits);
  for (int s = offset; s < dy; s += 16, edge.column += edge.step) {
    const int column = static_cast<int>(edge.column >> edge.fraction_bits) + edge.origin;
    wrong += ((column - exact_column(x0, dx, dy, s)) & (wraps - 1)) != 0;
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

Walked small(std::uint32_t column, std::uint32_t step) {
  return {column, step, small_triangle::fraction_bits, -small_triangle::margin};
}

TEST(SmallEdges, EdgesFromTheTopVertexAreExactForEverySlopeStartAndRow) {
  long rows = 0, wrong = 0;
  for (int dx = -small_triangle::reach; dx <= small_triangle::reach; dx += static_cast<int>(stride(11)))
    for (int dy = 1; dy <= small_triangle::max_height; ++dy)
      for (int sub_pixel = 0; sub_pixel < 16; ++sub_pixel)
        for (int offset = 0; offset < 16 && offset < dy; ++offset) {
          FixedEdges edges{};
          small_triangle::set_edges(triangle(sub_pixel, dx, dy, dx, dy),
                                    ThirdEdge::of(triangle(sub_pixel, dx, dy, dx, dy)), offset, 0, edges);
          wrong += wrong_rows(small(edges.left, edges.left_step), sub_pixel, dx, dy, offset);
          wrong += wrong_rows(small(edges.right, edges.right_step), sub_pixel, dx, dy, offset);
          rows += 2 * ((dy - offset + 15) / 16);
        }
  EXPECT_EQ(wrong, 0) << "of " << rows << " rows";
  std::printf("%ld rows of edges from the top\n", rows);
}

TEST(SmallEdges, ThirdEdgesAreExactForEverySlopeStartAndRow) {
  // From b at (start, 1) to c, or its mirror image on the left; the sub-pixel start comes with the top vertex.
  long rows = 0, wrong = 0;
  for (int dx = -2 * small_triangle::reach; dx <= 2 * small_triangle::reach; dx += static_cast<int>(stride(23)))
    for (int dy = 1; dy < small_triangle::max_height; ++dy)
      for (int sub_pixel = 0; sub_pixel < 16; ++sub_pixel)
        for (int offset = 0; offset < 16 && offset < dy; ++offset) {
          const int start = dx > 0 ? -(dx / 2) : (-dx + 1) / 2, end = start + dx;
          FixedEdges edges{};
          small_triangle::set_edges(triangle(sub_pixel, start, 1, end, 1 + dy),
                                    ThirdEdge::of(triangle(sub_pixel, start, 1, end, 1 + dy)), 0, offset, edges);
          wrong += wrong_rows(small(edges.third, edges.third_step), sub_pixel + start, dx, dy, offset);
          small_triangle::set_edges(triangle(sub_pixel, end, 1 + dy, start, 1),
                                    ThirdEdge::of(triangle(sub_pixel, end, 1 + dy, start, 1)), 0, offset, edges);
          wrong += wrong_rows(small(edges.third, edges.third_step), sub_pixel + start, dx, dy, offset);
          rows += 2 * ((dy - offset + 15) / 16);
        }
  EXPECT_EQ(wrong, 0) << "of " << rows << " rows";
  std::printf("%ld rows of third edges\n", rows);
}

// Every height; a part of the widths, starts and offsets, others in every build of a longer run.
TEST(MediumEdges, EdgesAreExactForEveryHeightAndRow) {
  Random random(8);
  long rows = 0, wrong = 0;
  for (int dy = 1; dy <= medium_triangle::max_height; ++dy)
    for (int i = 0; i < rounds(400); ++i) {
      const int widest = std::min(medium_triangle::max_width, medium_triangle::flattest * dy - 1);
      const int dx = i < 4 ? (i & 1 ? widest : -widest) + (i & 2 ? random.between(-2, 0) * (i & 1 ? 1 : -1) : 0)
                           : random.between(-widest, widest);
      const int sub_pixel = random.between(0, 15), offset = random.between(0, std::min(15, dy - 1));
      const int origin = row_at(ScreenVertex::bias + sub_pixel + std::min(0, dx)) - 1;
      const auto medium = [&](std::uint32_t column, std::uint32_t step) {
        return Walked{column, step, medium_triangle::fraction_bits, origin - row_bias};
      };
      FixedEdges edges{};
      medium_triangle::set_edges(triangle(sub_pixel, dx, dy, dx, dy),
                                 ThirdEdge::of(triangle(sub_pixel, dx, dy, dx, dy)), origin, offset, 0, edges);
      wrong += wrong_rows(medium(edges.left, edges.left_step), sub_pixel, dx, dy, offset);
      wrong += wrong_rows(medium(edges.right, edges.right_step), sub_pixel, dx, dy, offset);
      medium_triangle::set_edges(triangle(sub_pixel, 0, 0, dx, dy), ThirdEdge::of(triangle(sub_pixel, 0, 0, dx, dy)),
                                 origin, 0, offset, edges);
      wrong += wrong_rows(medium(edges.third, edges.third_step), sub_pixel, dx, dy, offset);
      rows += 3 * ((dy - offset + 15) / 16);
    }
  EXPECT_EQ(wrong, 0) << "of " << rows << " rows";
  std::printf("%ld rows of medium edges\n", rows);
}

// The same through the renderer: every dx and dy of an edge as the left and as the right side of a drawn triangle.
TEST(SmallEdges, EverySlopeDrawsExactlyTheRightPixels) {
  Studio<FlatTraits<Rgb565, Depth16<>>> studio(screen_capacity(40, 40, 1));
  Random random(3);
  long pixels = 0;
  for (int dx = -160; dx <= 160; dx += static_cast<int>(stride(8)))
    for (int dy = 1; dy <= 255; ++dy) {
      const int x = 320 + random.between(0, 15), y = 64 + random.between(0, 15), other = random.between(-160, 160),
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
