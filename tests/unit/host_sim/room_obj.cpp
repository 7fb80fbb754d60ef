#include "room_obj.hpp"

#include <cmath>
#include <iomanip>
#include <sstream>

namespace spanline::sim::test {
namespace {

struct Box {
  double x, z;               ///< of its middle
  double width, depth;       ///< along x and z
  double bottom, top;        ///< y
  double turn = 0;           ///< about its middle, radians
  bool from_within = false;  ///< its faces are seen from within
};

/// Appends a box whose corners are the vertices from `first` on.
void append(std::ostream& text, const Box& box, int first) {
  for (int corner = 0; corner < 8; ++corner) {
    const double along = ((corner & 1) != 0 ? 0.5 : -0.5) * box.width,
                 aside = ((corner & 2) != 0 ? 0.5 : -0.5) * box.depth;
    const double c = std::cos(box.turn), s = std::sin(box.turn);
    text << "v " << box.x + c * along + s * aside << ' ' << ((corner & 4) != 0 ? box.top : box.bottom) << ' '
         << box.z - s * along + c * aside << '\n';
  }
  constexpr int faces[6][4] = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}};
  for (const auto& face : faces) {
    text << 'f';
    for (int i = 0; i < 4; ++i) text << ' ' << first + face[box.from_within ? 3 - i : i];
    text << '\n';
  }
}

}  // namespace

std::string room_obj() {
  std::ostringstream text;
  text << std::fixed << std::setprecision(6);
  constexpr Box boxes[] = {
      {0, 0, 12, 10, -1.5, 1.5, 0, true}, {-5, -4, 1, 1.5, -1.5, 0.5},        {-3, -3.5, 0.8, 0.8, -1.5, -0.6, 0.5},
      {-1, -4.2, 1.4, 0.6, -1.5, 1.1},    {1.5, -3, 1, 1, -1.5, -0.5, 0.8},   {4.5, -4, 1.2, 1.1, -1.5, 0.2},
      {5, 0, 0.7, 2.5, -1.5, 0.9},        {4, 3.5, 1.5, 1, -1.5, -0.2, -0.3}, {1, 4, 0.9, 0.9, -1.5, 1.2, 1.1},
      {-2, 3.2, 1.1, 0.8, -1.5, -0.7},    {-5, 3.9, 1, 1, -1.5, 0.6, 0.2},    {-4.6, 0, 0.6, 1.6, -1.5, -0.1},
  };
  int first = 1;
  for (const Box& box : boxes) {
    append(text, box, first);
    first += 8;
  }
  return text.str();
}

}  // namespace spanline::sim::test
