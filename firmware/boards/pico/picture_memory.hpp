#pragma once
#include <cstddef>

namespace spanline::board {

/// RAM that a program may set aside for pictures, bytes: 232 KB less the stack and 8 KB for everything else.
inline constexpr std::size_t picture_memory = 220 * 1024;

}  // namespace spanline::board
