#pragma once
/// @file
/// The eye of a frame.
///
/// ```cpp
/// Camera camera;
/// camera.look_at({{}, 2.0_q16, 5.0_q16}, {}, {{}, 1.0_q30, {}});   // from where, at what, and what is up
/// camera.focal = Camera::focal_for(Angle::from_degrees(45), 240);  // of a picture 240 pixels high
/// camera.near_plane = 1.0_q16;
/// camera.far_plane = 20.0_q16;
/// ```
#include <cstdint>

#include "spanline/math/matrix.hpp"

namespace spanline {

/// How the world is projected to the screen.
enum class Projection : std::uint8_t {
  perspective,   ///< distant things appear smaller
  orthographic,  ///< everything appears at the same scale
};

/// The camera of a frame: right-handed, y up, looking along −z of its own axes, as in OpenGL.
///
/// Depth is (2ᴺ − 1)·(a + b/z) with a = f/(f − n), b = −f·n/(f − n) for a perspective view (Munzner, CPSC 314, 2010,
/// week 9, "Integer Depth Buffer"), and (2ᴺ − 1)·(z − n)/(f − n) for an orthographic one; z is the distance along the
/// viewing axis.
struct Camera {
  Projection projection = Projection::perspective;  ///< perspective by default
  Position eye{};  ///< position: world units, Q16.16, (−32768, 32768); the origin by default
  Rotation
      axes{};  ///< rows of Q2.30 in world space: right, up, backwards (towards the viewer); the world's axes by default
  /// Perspective: focal length in pixels, (height / 2) / tan(fov / 2). Orthographic: pixels a world unit. Q16.16, any
  /// value above 0; 240 by default, which is 53° over 240 lines.
  Q16_16 focal = Q16_16::from_int(240);
  Q16_16 near_plane = Q16_16::from_ratio(1, 10);  ///< world units, < far_plane; > 0 for perspective; 0.1 by default
  Q16_16 far_plane = Q16_16::from_int(100);       ///< world units, (near_plane, 32768); 100 by default

  /// Turns the camera towards `target`; `up` need not be normal to the view, but must not be parallel to it.
  constexpr void look_at(Position from, Position target, Direction up) {
    eye = from;
    const Direction backwards = direction_between(target, from);
    const Direction side = cross(up, backwards);
    const Direction right = normalise(side.x.raw(), side.y.raw(), side.z.raw());
    axes = {{right, cross(backwards, right), backwards}};
  }

  /// Focal length in pixels for a vertical field of view in (0°, 180°) and a picture `height` pixels high.
  [[nodiscard]] static constexpr Q16_16 focal_for(Angle field_of_view, int height) {
    const Angle half = Angle::from_raw(field_of_view.raw() / 2);
    const std::int64_t sine_half = sine(half).raw();
    const std::int64_t focal_raw =
        (static_cast<std::int64_t>(cosine(half).raw()) * height * 32768) / (sine_half > 0 ? sine_half : 1);
    return Q16_16::from_raw(static_cast<std::int32_t>(focal_raw > 0x7fffffff ? 0x7fffffff : focal_raw));
  }
};

}  // namespace spanline
