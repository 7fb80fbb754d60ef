#pragma once
/// @file
/// The names of a renderer's pools.
#include <cstdint>

namespace spanline {

/// The renderer's pools, which are parts of the caller's memory. The fields of Capacity with the same names say what
/// each pool holds. A Status names the pool that was too small.
enum class Pool : std::uint8_t {
  none,       ///< no pool is meant
  memory,     ///< the whole memory that the renderer was given
  instances,  ///< `Capacity::instances`
  vertices,   ///< `Capacity::vertices`
  shades,     ///< `Capacity::shades`
  textures,   ///< `Capacity::textures`
  polygons,   ///< `Capacity::polygons`
  fans,       ///< `Capacity::fans`
  active,     ///< `Capacity::active`
  awake,      ///< `Capacity::awake`
  fragments,  ///< `Capacity::fragments`
  layers,     ///< `Capacity::layers`
  members,    ///< `Capacity::members`
};

/// The pool's name in Capacity, for messages.
[[nodiscard]] constexpr const char* to_string(Pool pool) {
  constexpr const char* names[] = {"none", "memory", "instances", "vertices",  "shades", "textures", "polygons",
                                   "fans", "active", "awake",     "fragments", "layers", "members"};
  return names[static_cast<unsigned>(pool)];
}

/// A pool that became full while bands were drawn.
struct PoolShortage {
  Pool pool = Pool::none;    ///< `none` if every pool was large enough
  std::uint32_t wanted = 0;  ///< entries that the frame needs
};

}  // namespace spanline
