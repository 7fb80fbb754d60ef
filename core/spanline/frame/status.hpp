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

#include "spanline/memory/pool.hpp"

namespace spanline {

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

/// A short English name of the fault, for messages.
[[nodiscard]] constexpr const char* to_string(Fault fault) {
  constexpr const char* names[] = {"none",           "pool full",   "bad configuration", "bad settings",
                                   "shader missing", "sink failed", "too many triangles"};
  return names[static_cast<unsigned>(fault)];
}

}  // namespace spanline
