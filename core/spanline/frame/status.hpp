#pragma once
/// @file
/// How calls of a renderer went.
///
/// ```cpp
/// void report(const Status& status, void (*print)(const char* text)) {
///   if (status.ok()) return;
///   print(to_string(status.fault));
///   if (status.fault == Fault::pool_full) print(to_string(status.pool));  // its Capacity should be `status.wanted`
/// }
/// ```
#include <cstdint>

namespace spanline {

/// The renderer's pools: parts of the caller's memory.
/// Capacity's fields of the same names say what they hold.
enum class Pool : std::uint8_t {
  none,       ///< no pool is meant
  memory,     ///< all of it: the memory that the renderer was given
  instances,  ///< `Capacity::instances`
  vertices,   ///< `Capacity::vertices`
  shades,     ///< `Capacity::shades`
  textures,   ///< `Capacity::textures`
  polygons,   ///< `Capacity::polygons`
  fans,       ///< `Capacity::fans`
  active,     ///< `Capacity::active`
  layers,     ///< `Capacity::layers`
};

/// What went wrong.
enum class Fault : std::uint8_t {
  none,       ///< nothing
  pool_full,  ///< `pool` was too small; it would have taken `wanted` entries (bytes for `memory`). What fits was drawn
  bad_configuration,   ///< sizes outside their ranges
  bad_settings,        ///< near, far or focal outside their ranges
  shader_missing,      ///< no shader of the renderer's serves a material; the instance was left out
  sink_failed,         ///< the sink gave the frame up
  too_many_triangles,  ///< in one call: triangle numbers would not fit; nothing was added
};

/// How a call went.
struct [[nodiscard]] Status {
  Fault fault = Fault::none;  ///< what went wrong
  Pool pool = Pool::none;     ///< of `pool_full`: which
  std::uint32_t wanted = 0;   ///< of `pool_full`: the size that would have done; entries, bytes for `memory`
  /// Whether nothing went wrong.
  [[nodiscard]] constexpr bool ok() const { return fault == Fault::none; }
  /// Whether all of them are equal.
  friend constexpr bool operator==(const Status&, const Status&) = default;
};

/// The pool's name in Capacity, for messages.
[[nodiscard]] constexpr const char* to_string(Pool pool) {
  constexpr const char* names[] = {"none",     "memory",   "instances", "vertices", "shades",
                                   "textures", "polygons", "fans",      "active",   "layers"};
  return names[static_cast<unsigned>(pool)];
}
/// A short English name of the fault, for messages.
[[nodiscard]] constexpr const char* to_string(Fault fault) {
  constexpr const char* names[] = {"none",           "pool full",   "bad configuration", "bad settings",
                                   "shader missing", "sink failed", "too many triangles"};
  return names[static_cast<unsigned>(fault)];
}

}  // namespace spanline
