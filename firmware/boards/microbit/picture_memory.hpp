#pragma once
#include <cstddef>

namespace spanline::board {

/// RAM that a program may set aside for pictures, bytes: 16 KB less the stack and 256 bytes for everything else.
inline constexpr std::size_t picture_memory = 13'056;

}  // namespace spanline::board
