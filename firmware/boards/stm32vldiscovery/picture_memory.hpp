#pragma once
#include <cstddef>

namespace spanline::board {

/// RAM that a program may set aside for pictures, bytes: 8 KB less the stack and 256 bytes for everything else.
inline constexpr std::size_t picture_memory = 5'632;

}  // namespace spanline::board
