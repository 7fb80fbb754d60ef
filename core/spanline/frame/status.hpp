#pragma once
#include <cstdint>

namespace spanline {

/// The renderer's pools: parts of the caller's memory.
enum class Pool : std::uint8_t { none, memory, instances, vertices, shades, textures, polygons, fans, active, layers };

enum class Fault : std::uint8_t {
  none,
  pool_full,  ///< `pool` was too small; it would have taken `wanted` entries (bytes for `memory`). What fits was drawn
  bad_configuration,   ///< sizes outside their ranges
  bad_settings,        ///< near, far or focal outside their ranges
  shader_missing,      ///< no shader of the renderer's serves a material; the instance was left out
  sink_failed,         ///< the sink gave the frame up
  too_many_triangles,  ///< in one call: triangle numbers would not fit; nothing was added
};

/// How a call went.
struct [[nodiscard]] Status {
  Fault fault = Fault::none;
  Pool pool = Pool::none;
  std::uint32_t wanted = 0;
  [[nodiscard]] constexpr bool ok() const { return fault == Fault::none; }
  friend constexpr bool operator==(const Status&, const Status&) = default;
};

[[nodiscard]] constexpr const char* to_string(Pool pool) {
  constexpr const char* names[] = {"none",     "memory",   "instances", "vertices", "shades",
                                   "textures", "polygons", "fans",      "active",   "layers"};
  return names[static_cast<unsigned>(pool)];
}
[[nodiscard]] constexpr const char* to_string(Fault fault) {
  constexpr const char* names[] = {"none",           "pool full",   "bad configuration", "bad settings",
                                   "shader missing", "sink failed", "too many triangles"};
  return names[static_cast<unsigned>(fault)];
}

}  // namespace spanline
