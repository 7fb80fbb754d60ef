#pragma once
#include <string>

namespace spanline::sim::test {

/// A room of 12 by 3 by 10 units about the origin, seen from within, with eleven boxes that stand in it, some of them
/// turned: 72 quadrilaterals, those of the boxes counter-clockwise from outside.
[[nodiscard]] std::string room_obj();

}  // namespace spanline::sim::test
