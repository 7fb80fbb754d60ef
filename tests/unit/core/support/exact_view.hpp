#pragma once
#include <cmath>

#include "spanline/geometry/view_space.hpp"
#include "spanline/model/mesh.hpp"
#include "spanline/model/transform.hpp"

namespace spanline::test {

using Real = long double;

/// A fixed-point number as a real one.
template <class F>
[[nodiscard]] Real real(F f) {
  return std::ldexp(static_cast<Real>(f.raw()), -F::fraction_bits);
}

struct RealPoint {
  Real x, y, z;
};

/// A vertex as it should come out: view space in world units (z the distance along the axis of view), the screen in
/// sixteenths of a pixel, depth in units of the format, all unrounded.
struct ExactVertex {
  RealPoint view;
  Real x, y, depth;
};

/// Camera and transform by their definitions in floating point: world = translation + scale · R · (v + offset) · 2^e,
/// view by the camera's axes, screen by similar triangles, depth by the formulas of lecture 004.
class ExactView {
 public:
  ExactView(const FrameView& view, const Mesh& mesh, const Transform& transform)
      : view_(view), mesh_(mesh), transform_(transform) {}

  [[nodiscard]] RealPoint to_view(Real x, Real y, Real z) const {
    const Real step = std::ldexp(Real{1}, mesh_.step_exponent) * real(transform_.scale);
    const RealPoint model{(x + mesh_.offset.x) * step, (y + mesh_.offset.y) * step, (z + mesh_.offset.z) * step};
    const RealPoint turned = rotated(transform_.rotation, model);
    const Camera& c = view_.camera;
    const RealPoint from_eye{turned.x + real(transform_.translation.x) - real(c.eye.x),
                             turned.y + real(transform_.translation.y) - real(c.eye.y),
                             turned.z + real(transform_.translation.z) - real(c.eye.z)};
    const RealPoint view = rotated(c.axes, from_eye);
    return {view.x, view.y, -view.z};
  }

  [[nodiscard]] ExactVertex project(const RealPoint& p) const {
    const Real focal = real(view_.camera.focal) * 16;
    const Real divisor = view_.camera.projection == Projection::perspective ? p.z : Real{1};
    return {p, view_.viewport.width * Real{8} + focal * p.x / divisor,
            view_.viewport.height * Real{8} - focal * p.y / divisor, depth(p.z)};
  }

  [[nodiscard]] ExactVertex operator()(std::size_t index) const {
    if (mesh_.vertices.empty()) {
      const Vertex32& v = mesh_.wide_vertices[index];
      return project(to_view(v.x, v.y, v.z));
    }
    const Vertex16& v = mesh_.vertices[index];
    return project(to_view(v.x, v.y, v.z));
  }

  /// (2^N − 1)·(a + b/z), or (2^N − 1)·(z − n)/(f − n) for an orthographic view.
  [[nodiscard]] Real depth(Real z) const {
    const Real n = real(view_.camera.near_plane), f = real(view_.camera.far_plane);
    const Real full = std::ldexp(Real{1}, view_.depth_bits) - 1;
    if (view_.camera.projection == Projection::orthographic) return full * (z - n) / (f - n);
    return full * (f / (f - n) - f * n / (f - n) / z);
  }

 private:
  static RealPoint rotated(const Rotation& r, const RealPoint& p) {
    const auto row = [&](int i) { return real(r.row[i].x) * p.x + real(r.row[i].y) * p.y + real(r.row[i].z) * p.z; };
    return {row(0), row(1), row(2)};
  }

  const FrameView& view_;
  const Mesh& mesh_;
  const Transform& transform_;
};

}  // namespace spanline::test
