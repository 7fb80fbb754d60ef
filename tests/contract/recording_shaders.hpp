#pragma once
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <vector>

#include "scene.hpp"

namespace spanline::contract {

/// How often the spanning algorithm wrote each pixel of a scene's screen triangles.
struct Written {
  std::vector<std::uint32_t> times;  ///< line by line
  std::size_t outside = 0;           ///< writes of no pixel, or beyond the band's memory
};
[[nodiscard]] Written count_writes(const Scene& scene, int band_lines, std::uint32_t active);

/// A span as the spanning algorithm hands it to shading.
struct Span {
  int row, begin, end;
  std::uint32_t id;  ///< 0: the background
  friend bool operator==(const Span&, const Span&) = default;
};
std::ostream& operator<<(std::ostream& out, const Span& span);

/// The spans of a scene's screen triangles, in order.
[[nodiscard]] std::vector<Span> spans_of(const Scene& scene);

}  // namespace spanline::contract
