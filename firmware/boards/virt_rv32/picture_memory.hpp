#pragma once
#include <cstddef>

namespace spanline::board {

/// RAM that a program may set aside for pictures, bytes; the board has 8 MB.
inline constexpr std::size_t picture_memory = 1024 * 1024;

}  // namespace spanline::board
