// Highlights and point lights against the lectures' formula in floating point.
#include <gtest/gtest.h>

#include <optional>

#include "shade/shading_scene.hpp"
#include "spanline/frame/ready_made_traits.hpp"
#include "spanline/math/inverse_root.hpp"
#include "spanline/math/power.hpp"
#include "support/effort.hpp"
#include "support/one_coloured.hpp"

namespace spanline::test {
namespace {

TEST(InverseRoot, IsWithinTwoToTheMinus26OfTheRoot) {
  Random random(1);
  double worst = 0;
  for (int i = 0; i < rounds(300000); ++i) {
    const auto value = static_cast<std::uint32_t>(random.wide(std::int64_t{1} << 30, (std::int64_t{1} << 32) - 1));
    worst = std::max(worst, std::abs(inverse_root_32(value) * 0x1p-46 * std::sqrt(double{1} * value) - 1));
  }
  EXPECT_LE(worst, 0x1p-26);
  EXPECT_LE(inverse_root_32(1u << 30), 1u << 31);
  EXPECT_GE(inverse_root_32(0xffffffff), 1u << 30);
}

TEST(InverseRoot, DirectionsAreUnitVectorsOfAnyLength) {
  Random random(2);
  for (int i = 0; i < rounds(100000); ++i) {
    const std::int64_t reach = std::int64_t{1} << random.between(0, 61);
    const std::int64_t v[3] = {random.wide(-reach, reach), random.wide(-reach, reach), random.wide(-reach, reach)};
    const double length = std::sqrt(std::pow(double(v[0]), 2) + std::pow(double(v[1]), 2) + std::pow(double(v[2]), 2));
    if (length == 0) continue;
    const DirectedLength got = direction_and_length(v[0], v[1], v[2]);
    const double components[3] = {got.direction.x.raw() * 0x1p-30, got.direction.y.raw() * 0x1p-30,
                                  got.direction.z.raw() * 0x1p-30};
    for (int k = 0; k < 3; ++k) ASSERT_NEAR(components[k], double(v[k]) / length, 0x1p-25);
    ASSERT_NEAR(std::ldexp(std::sqrt(double(got.square)), got.exponent) / length, 1, 0x1p-27);
  }
  EXPECT_EQ(direction_and_length(0, 0, 0).square, 0u);
}

TEST(Power, IsWithinA2048thForEveryExponent) {
  Random random(3);
  double worst = 0;
  for (std::uint32_t exponent = 1; exponent <= 128; ++exponent)
    for (int i = 0; i < rounds(2000); ++i) {
      const double wanted = random.real(0, 1);  // the power, so that all of the curve is seen
      const double exact_base = std::pow(wanted, 1.0 / exponent);
      const auto base = static_cast<std::uint32_t>(std::lround(std::clamp(exact_base * 0x1p30, 1.0, 0x1p30)));
      const double got = power(base, exponent) / 65536.0;
      worst = std::max(worst, std::abs(got - std::pow(base * 0x1p-30, exponent)));
    }
  std::printf("powers are off by at most 1/%.0f\n", 1 / worst);
  EXPECT_LE(worst, 1.0 / 2048);
  EXPECT_EQ(power(1u << 30, 1), 65536u);
  EXPECT_EQ(power(1u << 30, 128), 65536u);
  EXPECT_EQ(power(1, 128), 0u);
  EXPECT_EQ(power(1, 1), 0u);
}

struct Real3 {
  double x, y, z;
  friend Real3 operator-(Real3 a, Real3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend double dot(Real3 a, Real3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
  [[nodiscard]] Real3 unit() const {
    const double length = std::sqrt(dot(*this, *this));
    return {x / length, y / length, z / length};
  }
};
Real3 real(const Position& p) {
  return {std::ldexp(p.x.raw(), -16), std::ldexp(p.y.raw(), -16), std::ldexp(p.z.raw(), -16)};
}
Real3 real(const Direction& d) { return {d.x.raw() * 0x1p-30, d.y.raw() * 0x1p-30, d.z.raw() * 0x1p-30}; }
Real3 turned(const Rotation& r, Real3 v) {
  return {dot(real(r.row[0]), v), dot(real(r.row[1]), v), dot(real(r.row[2]), v)};
}

/// A mesh somewhere in the world, with lights of both kinds around it, seen from somewhere.
struct LitInstance {
  RandomInstance instance;
  std::vector<DirectionalLight> lights;
  std::vector<PointLight> points;
  Lighting lighting;
  Material material;
  std::vector<RealNormal> vertex_normals, polygon_normals;

  explicit LitInstance(Random& random)
      : instance(random, {.wide = random.chance(3), .orthographic = random.chance(3), .vertices = 9}) {
    for (int i = 0; i < 9; ++i) vertex_normals.push_back(random_normal(random));
    for (int i = 0; i < 3; ++i) polygon_normals.push_back(random_normal(random));
    for (const RealNormal& n : vertex_normals) instance.owned.vertex_normals.push_back(n.packed);
    for (const RealNormal& n : polygon_normals) instance.owned.polygon_normals.push_back(n.packed);
    instance.mesh = instance.owned.view();
    lighting.ambient = nearest<Fixed<16>>(random.real(0, 0.3));
    const int count = random.between(0, 4);
    for (int i = 0; i < count; ++i) {
      const RealNormal n = random_normal(random);
      lights.push_back({normalise(n.packed.x(), n.packed.y(), n.packed.z()), nearest<Fixed<16>>(random.real(0, 0.7))});
    }
    const double radius = instance.owned.bounds.radius * instance.step_size();
    const Real3 middle = world_point(Real3{0, 0, 0}, true);
    for (int i = count; i < 4; ++i) {
      // From close by to far away; its range about as far.
      const double away = radius * std::exp2(random.real(-1, 5));
      const RealNormal n = random_normal(random);
      points.push_back({{nearest<Q16_16>(middle.x + n.x * away), nearest<Q16_16>(middle.y + n.y * away),
                         nearest<Q16_16>(middle.z + n.z * away)},
                        nearest<Fixed<16>>(random.real(0, 1.5)),
                        random.chance(3)
                            ? Q16_16{}
                            : nearest<Q16_16>(away * std::exp2(random.real(-1, random.chance(3) ? 20 : 3)))});
    }
    lighting.lights = lights;
    lighting.point_lights = points;
    material.specular = random.chance(5) ? Rgb888{0, 0, 0} : random_colour(random);
    material.shininess = static_cast<std::uint8_t>(random.between(1, 128));
  }

  [[nodiscard]] LocalLighting local() const {
    return {lighting, instance.view.camera, instance.mesh, instance.transform, material};
  }

  /// Steps of the mesh in the world; of the middle of its bounds where asked.
  [[nodiscard]] Real3 world_point(Real3 steps, bool centre = false) const {
    const OwnedMesh& owned = instance.owned;
    if (centre) steps = {double(owned.bounds.centre.x), double(owned.bounds.centre.y), double(owned.bounds.centre.z)};
    const double step = instance.step_size();
    const Real3 local{(steps.x + owned.offset.x) * step, (steps.y + owned.offset.y) * step,
                      (steps.z + owned.offset.z) * step};
    const Real3 turned_point = turned(instance.transform.rotation, local), at = real(instance.transform.translation);
    return {turned_point.x + at.x, turned_point.y + at.y, turned_point.z + at.z};
  }
  [[nodiscard]] Real3 vertex(std::size_t i) const {
    if (!instance.owned.wide_vertices.empty()) {
      const Vertex32& v = instance.owned.wide_vertices[i];
      return {double(v.x), double(v.y), double(v.z)};
    }
    const Vertex16& v = instance.owned.vertices[i];
    return {double(v.x), double(v.y), double(v.z)};
  }

  struct Expected {
    double diffuse, highlight;
  };
  /// By the formula; nothing where a light just grazes the surface, and a highlight may or may not be.
  [[nodiscard]] std::optional<Expected> formula(Real3 steps, const RealNormal& normal) const {
    const Real3 n = turned(instance.transform.rotation, {normal.x, normal.y, normal.z}), p = world_point(steps);
    const Camera& camera = instance.view.camera;
    const Real3 v =
        camera.projection == Projection::orthographic ? real(camera.axes.row[2]) : (real(camera.eye) - p).unit();
    double diffuse = std::ldexp(lighting.ambient.raw(), -16), highlight = 0;
    bool grazes = false;
    const auto shine = [&](Real3 l, double intensity) {
      const double cosine = dot(n, l);
      grazes = grazes || std::abs(cosine) < 1e-4;
      if (cosine <= 0) return;
      diffuse += intensity * cosine;
      if (!material.shines()) return;
      const double along = 2 * cosine * dot(n, v) - dot(l, v);
      if (along > 0) highlight += intensity * std::pow(std::min(along, 1.0), material.shininess);
    };
    for (const DirectionalLight& light : lights) shine(real(light.towards), std::ldexp(light.intensity.raw(), -16));
    for (const PointLight& light : points) {
      const Real3 way = real(light.position) - p;
      const double range = std::ldexp(light.range.raw(), -16), share = range == 0 ? 0 : dot(way, way) / (range * range);
      if (share < 1) shine(way.unit(), std::ldexp(light.intensity.raw(), -16) * (1 - share) * (1 - share));
    }
    if (grazes) return std::nullopt;
    return Expected{std::min(diffuse, 1.0), std::min(highlight, 1.0)};
  }
};

TEST(LocalLight, IsWithinA1024thOfTheFormula) {
  Random random(4);
  double worst_diffuse = 0, worst_highlight = 0;
  for (int i = 0; i < rounds(8000); ++i) {
    const LitInstance lit(random);
    const LocalLighting local = lit.local();
    const auto check = [&](const SurfaceLight& got, Real3 steps, const RealNormal& normal) {
      const auto wanted = lit.formula(steps, normal);
      if (!wanted) return;
      worst_diffuse = std::max(worst_diffuse, std::abs(got.diffuse / 65535.0 - wanted->diffuse));
      worst_highlight = std::max(worst_highlight, std::abs(got.highlight / 65535.0 - wanted->highlight));
    };
    for (std::size_t v = 0; v < 9; ++v) check(local.at_vertex(v), lit.vertex(v), lit.vertex_normals[v]);
    for (std::uint32_t t = 0; t < 3; ++t) {
      const Real3 a = lit.vertex(3 * t), b = lit.vertex(3 * t + 1), c = lit.vertex(3 * t + 2);
      check(local.on_polygon(t), {(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3, (a.z + b.z + c.z) / 3},
            lit.polygon_normals[t]);
    }
    ASSERT_LE(std::max(worst_diffuse, worst_highlight), 1.0 / 1024) << "round " << i;
  }
  std::printf("diffuse light is off by at most 1/%.0f, highlights by 1/%.0f\n", 1 / worst_diffuse, 1 / worst_highlight);
}

TEST(LocalLight, PicturesHaveItFlatAndSmooth) {
  Random random(5);
  Capacity capacity = mesh_capacity(ShadedTriangle::size, ShadedTriangle::size, 1, 3, 1);
  capacity.active = capacity.awake = 1;
  for (int i = 0; i < rounds(400); ++i) {
    ShadedTriangle t(random);
    t.owned.vertices = {{-512, -512, 0}, {512, -512, 0}, {0, 512, 0}};
    t.owned.fit_bounds();
    for (int k = 0; k < 3; ++k) t.owned.vertex_normals.push_back(PackedNormal(0, 0, 511));
    t.owned.polygon_normals = {PackedNormal(0, 0, 511)};
    const std::vector<PointLight> points{{{nearest<Q16_16>(random.real(-30, 30)), nearest<Q16_16>(random.real(-30, 30)),
                                           nearest<Q16_16>(random.real(-95, 0))},
                                          nearest<Fixed<16>>(random.real(0, 2)),
                                          nearest<Q16_16>(random.real(20, 200))}};
    t.settings.lighting = {nearest<Fixed<16>>(random.real(0, 0.3)), {}, points};
    const OneColouredSolid solid(Rgb565::from(random_colour(random)));
    const Rgb888 colour = widened(solid.colour());
    Material material{colour, random.chance(2) ? ShadingMode::flat : ShadingMode::gouraud};
    material.specular = random.chance(4) ? Rgb888{0, 0, 0} : random_colour(random);
    material.shininess = static_cast<std::uint8_t>(random.between(1, 128));
    const Mesh mesh = t.owned.view();
    const LocalLighting local(t.settings.lighting, t.settings.camera, mesh, t.transform, material);
    const auto draw = [&]<class Traits>(Traits*) {
      Studio<Traits> studio(capacity);
      studio.begin(t.settings);
      studio.add(mesh, t.transform, material);
      auto picture = studio.draw();
      EXPECT_TRUE(studio.status().ok());
      return picture.pixels[picture.at(32, 32)];
    };
    // The corners' shares at the centre of the middle pixel.
    const auto mean = [](auto value) {
      const double top = 0.5 - 0.5 / 64, beside = (1 - top) / 2;
      return value(0) * (beside - 0.5 / 64) + value(1) * (beside + 0.5 / 64) + value(2) * top;
    };
    const auto sum = [](std::uint8_t own, double diffuse, std::uint8_t shine, double highlight) {
      return std::min(255.0, own * diffuse / 65535.0 + shine * highlight / 65535.0) / 255;
    };
    const auto channel = [&](std::uint8_t own, std::uint8_t shine) {
      const auto lit = [&](const SurfaceLight& light) { return sum(own, light.diffuse, shine, light.highlight); };
      if (material.shading == ShadingMode::flat) return lit(local.on_polygon(0));
      // Of a solid both are interpolated, and added for each pixel; other surfaces' vertices have a colour.
      if (material.volume.source != SolidSource::none)
        return sum(own, mean([&](std::size_t v) { return local.at_vertex(v).diffuse; }), shine,
                   mean([&](std::size_t v) { return local.at_vertex(v).highlight; }));
      return mean([&](std::size_t v) { return lit(local.at_vertex(v)); });
    };
    const auto check = [&](std::uint16_t pixel) {
      const Channels got(pixel);
      EXPECT_LE(std::abs(got.red - std::lround(channel(material.colour.red, material.specular.red) * 31)), 1) << i;
      EXPECT_LE(std::abs(got.green - std::lround(channel(material.colour.green, material.specular.green) * 63)), 1)
          << i;
      EXPECT_LE(std::abs(got.blue - std::lround(channel(material.colour.blue, material.specular.blue) * 31)), 1) << i;
    };
    // Fog that begins far behind asks for the general shader.
    check(draw(static_cast<LocalLightTraits<>*>(nullptr)));
    check(draw(static_cast<LocalLightTraits<Rgb565, Depth24<>, Spanning>*>(nullptr)));
    t.settings.fog = {FogCurve::linear, Q16_16::from_int(500), Q16_16::from_int(900), {}};
    check(draw(static_cast<GeneralTraits<>*>(nullptr)));
    t.settings.fog = {};
    material.volume = solid.volume();
    check(draw(static_cast<GeneralTraits<>*>(nullptr)));
    ASSERT_FALSE(HasFailure()) << "round " << i;
  }
}

TEST(LocalLight, RenderersWithoutItRefuse) {
  Random random(6);
  ShadedTriangle t(random);
  const Mesh mesh = t.owned.view();
  const std::vector<PointLight> points(1);
  Studio<GouraudTraits<>> studio(mesh_capacity(ShadedTriangle::size, ShadedTriangle::size, 1, 3, 1));
  Material shiny;
  shiny.specular = {255, 255, 255};
  for (const ShadingMode mode : {ShadingMode::flat, ShadingMode::gouraud}) {
    shiny.shading = mode;
    studio.begin(t.settings);
    studio.add(mesh, t.transform, shiny);
    EXPECT_EQ(studio.status().fault, Fault::shader_missing);
    t.settings.lighting.point_lights = points;
    studio.begin(t.settings);
    studio.add(mesh, t.transform, {{}, mode});
    EXPECT_EQ(studio.status().fault, Fault::shader_missing);
    t.settings.lighting.point_lights = {};
  }
}

}  // namespace
}  // namespace spanline::test
