// Surfaces cut from solids: the colour of every pixel is that of its point in the mesh's space.
#include <gtest/gtest.h>
#include <spanline/model/cull.hpp>

#include <array>
#include <cmath>
#include <vector>

#include "shade/shading_scene.hpp"
#include "support/effort.hpp"

namespace spanline::test {
namespace {

/// Shows a coordinate itself: its upper 16 bits.
template <unsigned Axis>
struct CoordinateSolid {
  static constexpr SolidSource source = SolidSource::function;
  [[nodiscard]] static std::uint16_t at(const Volume&, std::uint32_t s, std::uint32_t t, std::uint32_t r) {
    return static_cast<std::uint16_t>((Axis == 0 ? s : Axis == 1 ? t : r) >> 16);
  }
};

template <class Solid, class Depth = Depth24<>, class Visibility = ZBuffer>
using SolidTraits =
    RendererTraits<Rgb565, ShaderList<FlatShader<Rgb565>, GouraudShader<Rgb565>, VolumeShader<Rgb565, Solid>>, Depth,
                   Visibility>;

/// One triangle that may need clipping, under full light.
struct SolidTriangle {
  RandomInstance instance;
  FrameSettings settings;
  Material material;

  explicit SolidTriangle(Random& random, bool clipped)
      : instance(random, {.wide = random.chance(3),
                          .orthographic = random.chance(4),
                          .closest = clipped ? 0.3 : 1.3,
                          .farthest = 6,
                          .range_around = !clipped,
                          .vertices = 3}) {
    settings.camera = instance.view.camera;
    settings.cull = Cull::none;
    settings.background = {0, 0, 0};
    // The cube is a few times as large as the mesh: its coordinates stay off the seam.
    const double radius = std::max(1.0, double{1} * instance.owned.bounds.radius);
    int exponent = 0;
    const double scale = std::frexp(0.2 / radius / std::exp2(instance.owned.step_exponent), &exponent);
    material.volume.source = SolidSource::function;
    material.volume.scale = nearest<Q16_16>(scale);
    material.volume.exponent = static_cast<std::int8_t>(std::clamp(exponent, -30, 30));
    const auto origin = [&](std::int32_t centre, std::int32_t offset) {
      return nearest<Q16_16>(0.5 - (double{1} * centre + offset) * steps_to_cubes());
    };
    const OwnedMesh& owned = instance.owned;
    material.volume.origin = {origin(owned.bounds.centre.x, owned.offset.x),
                              origin(owned.bounds.centre.y, owned.offset.y),
                              origin(owned.bounds.centre.z, owned.offset.z)};
  }
  [[nodiscard]] double steps_to_cubes() const {
    return std::ldexp(material.volume.scale.raw(), -16 + material.volume.exponent + instance.owned.step_exponent);
  }

  /// The point of the triangle's plane behind a pixel's centre, in the cube; the mesh's own space is found by solving
  /// for the point where the line of sight meets the plane.
  [[nodiscard]] bool point_at(int x, int y, std::array<double, 3>& cube) const {
    const auto q = [](Q2_30 v) { return v.raw() * 0x1p-30; };
    const auto w = [](Q16_16 v) { return std::ldexp(v.raw(), -16); };
    const Camera& camera = settings.camera;
    const double focal = w(camera.focal);
    const double px = (x + 0.5 - instance.view.viewport.width / 2.0) / focal,
                 py = -(y + 0.5 - instance.view.viewport.height / 2.0) / focal;
    const bool flat = camera.projection == Projection::orthographic;
    const double origin_view[3] = {flat ? px : 0, flat ? py : 0, 0}, way_view[3] = {flat ? 0 : px, flat ? 0 : py, -1};
    double origin[3], way[3];
    for (int i = 0; i < 3; ++i) {
      const auto along = [&](const double* v) {
        const auto c = [&](const Direction& d) { return i == 0 ? q(d.x) : i == 1 ? q(d.y) : q(d.z); };
        return c(camera.axes.row[0]) * v[0] + c(camera.axes.row[1]) * v[1] + c(camera.axes.row[2]) * v[2];
      };
      const auto eye = i == 0 ? camera.eye.x : i == 1 ? camera.eye.y : camera.eye.z;
      const auto at = i == 0   ? instance.transform.translation.x
                      : i == 1 ? instance.transform.translation.y
                               : instance.transform.translation.z;
      origin[i] = along(origin_view) + w(eye) - w(at);
      way[i] = along(way_view);
    }
    // Into the mesh's steps: turned back and scaled.
    const double step = instance.step_size();
    const auto local = [&](const double* v) {
      std::array<double, 3> result{};
      for (int i = 0; i < 3; ++i) {
        const Direction column = instance.transform.rotation.column(i);
        result[static_cast<std::size_t>(i)] = (q(column.x) * v[0] + q(column.y) * v[1] + q(column.z) * v[2]) / step;
      }
      return result;
    };
    const std::array<double, 3> from = local(origin), along = local(way);
    std::array<std::array<double, 3>, 3> corner{};
    const OwnedMesh& owned = instance.owned;
    for (std::size_t i = 0; i < 3; ++i) {
      const bool wide = !owned.wide_vertices.empty();
      corner[i] = {double{1} * owned.offset.x + (wide ? owned.wide_vertices[i].x : owned.vertices[i].x),
                   double{1} * owned.offset.y + (wide ? owned.wide_vertices[i].y : owned.vertices[i].y),
                   double{1} * owned.offset.z + (wide ? owned.wide_vertices[i].z : owned.vertices[i].z)};
    }
    double e[3], f[3], n[3];
    for (std::size_t k = 0; k < 3; ++k) {
      e[k] = corner[1][k] - corner[0][k];
      f[k] = corner[2][k] - corner[0][k];
    }
    double length_n = 0, length_way = 0, above = 0, fall = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      n[k] = e[(k + 1) % 3] * f[(k + 2) % 3] - e[(k + 2) % 3] * f[(k + 1) % 3];
      length_n += n[k] * n[k];
      length_way += along[k] * along[k];
      above += n[k] * (corner[0][k] - from[k]);
      fall += n[k] * along[k];
    }
    // Seen edge on, or thin, the snapping of corners to sixteenths moves points far.
    if (std::abs(fall) < 0.25 * std::sqrt(length_n * length_way)) return false;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t raw = k == 0   ? material.volume.origin.x.raw()
                               : k == 1 ? material.volume.origin.y.raw()
                                        : material.volume.origin.z.raw();
      cube[k] = (from[k] + along[k] * above / fall) * steps_to_cubes() + std::ldexp(raw, -16);
    }
    return true;
  }
};

TEST(Volume, PixelsShowTheirPointOfTheSolid) {
  Random random(1);
  double worst = 0;
  long pixels = 0, far_off = 0;
  constexpr int triangles = 24;  // a sample that is whole under sanitizers as well
  for (int i = 0; i < triangles; ++i) {
    const SolidTriangle t(random, i % 2 == 1);
    const std::array<std::vector<std::uint16_t>, 3> shown{
        instance_pixels<SolidTraits<CoordinateSolid<0>>>(t.instance, t.settings, t.material, 4096),
        instance_pixels<SolidTraits<CoordinateSolid<1>>>(t.instance, t.settings, t.material, 4096),
        instance_pixels<SolidTraits<CoordinateSolid<2>>>(t.instance, t.settings, t.material, 4096)};
    const int width = t.instance.view.viewport.width, height = t.instance.view.viewport.height;
    for (int y = 0; y < height; y += 4)
      for (int x = 0; x < width; x += 5) {
        const auto p = static_cast<std::size_t>(y * width + x);
        std::array<double, 3> wanted{};
        if ((shown[0][p] | shown[1][p] | shown[2][p]) == 0 || !t.point_at(x, y, wanted)) continue;
        // A pixel's own size in the cube, by its neighbour.
        std::array<double, 3> beside{};
        if (!t.point_at(x + 1, y, beside)) continue;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          // RGB565 under full light is the word itself but for its rounding.
          const double off = std::abs(shown[axis][p] / 65536.0 - wanted[axis]);
          const double pixel = std::abs(beside[axis] - wanted[axis]);
          const double allowed = 1.0 / 1024 + pixel;
          ++pixels;
          if (off > allowed)
            ++far_off;
          else
            worst = std::max(worst, off / allowed);
        }
      }
  }
  std::printf("solid: %ld of %ld coordinates are off by more than a pixel and 1/1024 of the cube\n", far_off, pixels);
  EXPECT_GT(pixels, 10000);
  EXPECT_LE(far_off, pixels / 10000);
}

TEST(Volume, BandsAndSpansDrawTheSameBytesOfATable) {
  Random random(2);
  std::vector<std::uint8_t> cells;
  std::vector<std::uint16_t> palette;
  for (int i = 0; i < 16 * 16 * 16; ++i) cells.push_back(static_cast<std::uint8_t>(random.between(0, 255)));
  for (int i = 0; i < 256; ++i) palette.push_back(static_cast<std::uint16_t>(random.between(0, 65535)));
  VolumeTexture table;
  table.log2_size = 4;
  table.cells = cells;
  table.palette = palette;
  ASSERT_TRUE(table.valid());
  for (int i = 0; i < rounds(30); ++i) {
    ShadedInstance shaded(random);
    add_effects(random, shaded.settings);
    Material material{random_colour(random), random.chance(2) ? ShadingMode::flat : ShadingMode::gouraud};
    material.volume.source = SolidSource::table;
    material.volume.texture = &table;
    material.volume.exponent = static_cast<std::int8_t>(random.between(-8, 4));
    expect_alike_in_bands_and_spans<SolidTraits<TableSolid>, SolidTraits<TableSolid, Depth24<>, Spanning>>(
        shaded.instance, shaded.settings, material);
    ASSERT_FALSE(HasFailure()) << "round " << i;
  }
}

}  // namespace
}  // namespace spanline::test
