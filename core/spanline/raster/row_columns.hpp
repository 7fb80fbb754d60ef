#pragma once
#include <cstdint>

namespace spanline {

/// Columns [first, end) of a row. For a triangle that is being stepped, they count from its column of origin; those of
/// a large triangle may lie outside the viewport.
struct RowColumns {
  std::int32_t first, end;
};

}  // namespace spanline
