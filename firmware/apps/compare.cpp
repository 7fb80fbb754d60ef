// Compares the visibility algorithms where they differ most: by how often a pixel is covered, and by the size of
// polygons. Prints `compare <complexity> <leg> <visibility> <instructions> <pixels>` for each; 0 instructions where
// more polygons are awake than the pool holds.
#include <algorithm>
#include <spanline/frame/ready_made_traits.hpp>
#include <spanline/model/cull.hpp>

#include "board.hpp"
#include "measured_frame.hpp"
#include "scenes/screen_soups.hpp"

namespace {

using namespace spanline;

constexpr std::uint32_t most_triangles = 65'000, most_a_call = 32'767;
constexpr std::uint32_t most_awake = 600, most_active = 4'000;
alignas(8) std::byte memory[1'200'000];
ScreenVertex vertices[3 * most_triangles];
std::uint16_t colours[most_triangles];

struct Case {
  std::uint32_t complexity, leg, triangles;
  std::uint16_t width, height;
};

void print(const Case& c, const char* visibility, std::uint32_t instructions) {
  board::write("compare");
  for (const std::uint32_t number : {c.complexity, c.leg}) {
    board::write(" ");
    board::write_unsigned(number);
  }
  board::write(" ");
  board::write(visibility);
  for (const std::uint32_t number : {instructions, std::uint32_t{c.width} * c.height}) {
    board::write(" ");
    board::write_unsigned(number);
  }
  board::write("\n");
}

template <class Depth, class Visibility>
void draw(const Case& c, unsigned band) {
  using Traits = FlatTraits<Rgb565, Depth, Visibility>;
  const scenes::ScreenSoup soup{std::span(vertices).first(std::size_t{3} * c.triangles),
                                std::span(colours).first(c.triangles)};
  scenes::make_even_cover(c.leg, c.width, c.height, Depth::bits, soup);
  const Capacity capacity{.width = c.width,
                          .height = c.height,
                          .instances = most_triangles / most_a_call + 1,
                          .polygons = c.triangles,
                          .active = std::min(c.triangles, most_active),
                          .awake = std::min(c.triangles, most_awake)};
  const measured::Frame frame = measured::warm_frame<Traits>(capacity, band, memory, [&](auto& renderer) {
    FrameSettings settings;
    settings.cull = Cull::none;
    (void)renderer.begin(settings);
    for (std::uint32_t first = 0; first < c.triangles; first += most_a_call) {
      const std::uint32_t count = c.triangles - first < most_a_call ? c.triangles - first : most_a_call;
      const Status added = renderer.add_screen(soup.vertices.subspan(std::size_t{3} * first, std::size_t{3} * count),
                                               soup.colours.subspan(first, count));
      if (!added.ok()) board::write("compare: not all could be added\n");
    }
  });
  print(c, measured::visibility_name<Traits>(band), frame.complete ? frame.instructions : 0);
}

/// Polygons too many for the links of a 32-bit machine are thrown over a smaller picture.
void cover(std::uint32_t complexity, std::uint32_t leg) {
  Case c{complexity, leg, 0, 320, 240};
  while ((c.triangles = scenes::even_cover_count(complexity, leg, c.width, c.height)) > most_triangles) {
    c.width /= 2;
    c.height /= 2;
  }
  draw<Depth16<>, ZBuffer>(c, 0);
  draw<Depth16<>, BoundedZBuffer>(c, 0);
  draw<Depth16<>, ZBuffer>(c, 16);
  draw<Depth24<>, Spanning>(c, 16);
}

}  // namespace

int main() {
  for (const std::uint32_t complexity : {1U, 2U, 5U, 10U, 20U})
    for (const std::uint32_t leg : {4U, 8U, 16U, 32U, 64U, 128U, 256U}) cover(complexity, leg);
  return 0;
}
