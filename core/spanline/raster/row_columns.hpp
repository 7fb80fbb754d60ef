#pragma once
#include <cstdint>

namespace spanline {

/// Columns [first, end) of a row. Of a triangle that is being stepped they count from the triangle's column of origin,
/// and those of a large one may leave the viewport.
struct RowColumns {
  std::int32_t first, end;
};

}  // namespace spanline
