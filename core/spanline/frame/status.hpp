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
#include <cstddef>
#include <cstdint>
#include <iterator>

#include "spanline/memory/pool.hpp"

namespace spanline {

/// What a renderer's list of shaders would have to have to draw an instance.
enum class MissingShader : std::uint8_t {
  none,                 ///< nothing is missing
  flat,                 ///< FlatShader
  gouraud,              ///< GouraudShader
  vertex_colours,       ///< GouraudColourShader: colours of vertices, or highlights, that are interpolated
  texture,              ///< one that draws textures, or one for the format, filter, function or light of this texture
  cut_out_texture,      ///< texels that are not there, by an algorithm without depths: it wants see-through shaders
  see_through,          ///< SeeThroughShader around the shader of the surface: opacity below 255, or Transparency::add
  translucent_texture,  ///< the same for a surface with a texture: around TranslucentShader
  varying_opacity,      ///< the same for opacities of vertices
  fog,                  ///< one that draws the surface in fog: GeneralShader
  dither,               ///< one that dithers the surface: GeneralShader
  local_light,          ///< LocalFlatShader: point lights and highlights
  relief,               ///< ReliefShader
  volume,               ///< VolumeShader
  mixture,  ///< there is none for a relief of a solid or in local light, nor for either with varying opacity
};

/// Why a call did not do all that it was asked.
enum class Fault : std::uint8_t {
  none,       ///< nothing
  pool_full,  ///< `pool` was too small; it would have taken `wanted` entries (bytes for `memory`). What fits was drawn
  bad_configuration,  ///< sizes outside their ranges; where it is a pool's, `pool` names it and `wanted` the most
  bad_planes,         ///< near is not below far, or not above 0 in perspective
  bad_focal,          ///< the focal length is not above 0
  too_many_lights,    ///< more than Lighting::max_lights of a kind: `wanted` of them
  no_frame,           ///< no frame was begun that this call could go on with
  bad_step,           ///< a step of drawing out of its turn, or a band that the picture does not have
  outside_picture,    ///< a pixel that the picture does not have
  shader_missing,     ///< no shader of the renderer's serves a material; `missing` says what. The instance was left out
  sink_failed,        ///< the sink gave the frame up
  too_many_triangles,  ///< in one call: triangle numbers would not fit; nothing was added
  no_world,            ///< polygons on the screen for an algorithm that works in the world; nothing was added
  bad_order,           ///< an order of submission names an instance, or polygons, that do not exist; the rest was added
  bad_corners,         ///< corner counts beyond [3, 8], or not as many corners as vertices; nothing was added
};

/// How a call went.
struct [[nodiscard]] Status {
  Fault fault = Fault::none;                    ///< what went wrong
  Pool pool = Pool::none;                       ///< of `pool_full` and `bad_configuration`: which
  MissingShader missing = MissingShader::none;  ///< of `shader_missing`: which
  /// Of `pool_full`: the size that would have done, in entries, bytes for `memory`; of others as they say.
  std::uint32_t wanted = 0;

  constexpr Status() = default;                ///< nothing went wrong
  constexpr Status(Fault why) : fault(why) {}  ///< a fault that says all
  /// A fault of a pool, or with a number.
  constexpr Status(Fault why, Pool which, std::uint32_t how_many) : fault(why), pool(which), wanted(how_many) {}
  /// The fault `shader_missing`, or none.
  constexpr Status(MissingShader what)
      : fault(what == MissingShader::none ? Fault::none : Fault::shader_missing), missing(what) {}

  /// Whether nothing went wrong.
  [[nodiscard]] constexpr bool ok() const { return fault == Fault::none; }
  /// Whether all of them are equal.
  friend constexpr bool operator==(const Status&, const Status&) = default;
};

/// What has no shader, for messages: "it has no shader for …".
[[nodiscard]] constexpr const char* to_string(MissingShader missing) {
  constexpr const char* names[] = {"none",
                                   "flat shading",
                                   "Gouraud shading",
                                   "colours of vertices",
                                   "this texture",
                                   "a texture with holes",
                                   "see-through surfaces",
                                   "see-through textures",
                                   "opacities of vertices",
                                   "fog on this surface",
                                   "dither on this surface",
                                   "point lights and highlights",
                                   "relief",
                                   "solids",
                                   "this mixture of effects"};
  static_assert(std::size(names) == static_cast<std::size_t>(MissingShader::mixture) + 1);
  return names[static_cast<unsigned>(missing)];
}
/// A short English name of the fault, for messages.
[[nodiscard]] constexpr const char* to_string(Fault fault) {
  constexpr const char* names[] = {"none",
                                   "pool full",
                                   "bad configuration",
                                   "near and far planes out of range",
                                   "focal length out of range",
                                   "too many lights",
                                   "no frame begun",
                                   "step out of turn",
                                   "outside the picture",
                                   "shader missing",
                                   "sink failed",
                                   "too many triangles",
                                   "polygons on the screen for an algorithm of the world",
                                   "order of submission names what does not exist",
                                   "corner counts that are not those of the vertices"};
  static_assert(std::size(names) == static_cast<std::size_t>(Fault::bad_corners) + 1);
  return names[static_cast<unsigned>(fault)];
}

}  // namespace spanline
