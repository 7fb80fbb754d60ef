#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "spanline/visibility/algorithm_needs.hpp"

namespace spanline {

// Every visibility algorithm that there is, as programs see it that let somebody choose. algorithms.def says what each
// column means; it is the only place to edit.

/// An algorithm by its identifier.
enum class AlgorithmId : std::uint8_t {
#define SPANLINE_ALGORITHM(id, ...) id,
#include "spanline/visibility/algorithms.def"
};

/// What an algorithm promises of its pictures.
enum class Exactness : std::uint8_t {
  exact,        ///< the bytes of the 24-bit z-buffer, always
  near_exact,   ///< at most 1 % of the pixels differ, each within one pixel of an edge or split
  order_bound,  ///< the z-buffer's pixel where no two polygons that cover it overlap in depth; polygons and background
                ///< where it has them
};

[[nodiscard]] constexpr const char* to_string(Exactness exactness) {
  switch (exactness) {
    case Exactness::exact:
      return "exact";
    case Exactness::near_exact:
      return "near-exact";
    case Exactness::order_bound:
      break;
  }
  return "order-bound";
}

/// How much of a picture an algorithm draws at a time.
enum class AlgorithmExtent : std::uint8_t { bands, the_whole_picture };

/// A line of the registry.
struct AlgorithmEntry {
  AlgorithmId id;
  const char* name;  ///< on the command line
  Exactness exactness;
  AlgorithmNeeds needs;
  AlgorithmExtent works_on;
  int depth_bits;  ///< where nobody asks for others: 16 or 24
  const char* description;
  std::string_view option;  ///< of renderer traits: lines that have the same share a translation unit

  [[nodiscard]] constexpr bool full_frame() const { return works_on == AlgorithmExtent::the_whole_picture; }
  [[nodiscard]] constexpr bool takes_screen_polygons() const { return needs == AlgorithmNeeds::screen_polygons; }
};

/// All lines, in their order.
inline constexpr auto algorithm_registry = std::to_array<AlgorithmEntry>({
#define SPANLINE_ALGORITHM(id, name, option, board_option, header, exactness, needs, works_on, depth_bits, \
                           description)                                                                    \
  {AlgorithmId::id,           name,       Exactness::exactness, AlgorithmNeeds::needs,                     \
   AlgorithmExtent::works_on, depth_bits, description,          #option "," #board_option},
#include "spanline/visibility/algorithms.def"
});

[[nodiscard]] constexpr const AlgorithmEntry& entry_of(AlgorithmId id) {
  return algorithm_registry[static_cast<std::size_t>(id)];
}

/// The first algorithm with the same options: the build makes one translation unit for all that share them.
[[nodiscard]] consteval AlgorithmId unit_of(AlgorithmId id) {
  for (const AlgorithmEntry& entry : algorithm_registry)
    if (entry.option == entry_of(id).option) return entry.id;
  return id;
}

/// Calls f.template operator()<unit_of(id)>(), all of whose results are of one type.
template <class F>
constexpr auto with_unit(AlgorithmId id, F&& f) {
  switch (id) {
#define SPANLINE_ALGORITHM(id, ...) \
  case AlgorithmId::id:             \
    return f.template operator()<unit_of(AlgorithmId::id)>();
#include "spanline/visibility/algorithms.def"
  }
  return decltype(f.template operator()<AlgorithmId{}>())();
}

/// Names that a later version brings, for one line of an error.
inline constexpr auto algorithms_to_come = std::to_array<std::string_view>({
#define SPANLINE_ALGORITHM_TO_COME(name) name,
#include "spanline/visibility/algorithms.def"
});

}  // namespace spanline
