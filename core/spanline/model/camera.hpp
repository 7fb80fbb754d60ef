#pragma once
#include <cstdint>

#include "spanline/math/matrix.hpp"

namespace spanline {

enum class Projection : std::uint8_t { perspective, orthographic };

/// The eye: right-handed, y up, looking along −z of its own axes, as in OpenGL.
///
/// Depth is (2ᴺ − 1)·(a + b/z) with a = f/(f − n), b = −f·n/(f − n) for a perspective view (Munzner, CPSC 314 week 9,
/// "Depth Test Precision"), and (2ᴺ − 1)·(z − n)/(f − n) for an orthographic one; z is the distance along the axis of
/// view.
struct Camera {
  Projection projection = Projection::perspective;
  Position eye{};
  Rotation axes{};  ///< rows: right, up, backwards (towards the viewer), world space
  /// Perspective: focal length in pixels, (height / 2) / tan(fov / 2). Orthographic: pixels a world unit. (0, 32767).
  Q16_16 focal = Q16_16::from_int(240);
  Q16_16 near_plane = Q16_16::from_ratio(1, 10);  ///< world units, > 0 for perspective, < far_plane
  Q16_16 far_plane = Q16_16::from_int(100);       ///< world units

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
