#include "spanline/shade/pixelwise/relief.hpp"

#include "spanline/math/inverse_root.hpp"
#include "spanline/model/texel_reader.hpp"

namespace spanline {
namespace {

/// 256 / √(1 + x) − 1 for x in 64ths of [0, 8].
constexpr unsigned steps_a_unit = 64;
constexpr std::array<std::uint8_t, 8 * steps_a_unit + 1> shortening = [] {
  std::array<std::uint8_t, 8 * steps_a_unit + 1> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    // Twice the value, for rounding: 2 · 256 · √(64 / (64 + i)), taken at the middle of the entry's interval.
    const std::uint64_t square = (std::uint64_t{1} << 18) * 2 * steps_a_unit / (2 * steps_a_unit + 2 * i + 1);
    table[i] = static_cast<std::uint8_t>((square_root(square) + 1) / 2 - 1);
  }
  return table;
}();

/// The sum of the group's lights, in the units of ModelLight.
Vec3<std::int32_t> sum_of_lights(const ShadingGroup& group) {
  Vec3<std::int32_t> sum{};
  for (unsigned i = 0; i < group.light_count; ++i)
    sum = sum + Vec3<std::int32_t>{group.lights[i].x, group.lights[i].y, group.lights[i].z};
  return sum;
}

/// The light that falls along a unit direction, 2^14 for full light; negative from behind.
std::int32_t along(const Vec3<std::int32_t>& lights, const Direction& direction) {
  const auto part = [](std::int32_t light, Q2_30 d) { return static_cast<std::int64_t>(light) * d.raw(); };
  // A component of ModelLight is in units of 1/(65536 · 64 / 511).
  return static_cast<std::int32_t>(
      ((part(lights.x, direction.x) + part(lights.y, direction.y) + part(lights.z, direction.z)) >> 16) * 511 >> 22);
}

/// One component, −1, 0 or 1, of the step to that of the eight neighbours of a texel which lies nearest to a direction.
std::int32_t to_neighbour(std::int32_t part, std::int32_t other) {
  constexpr std::int32_t tangent = 106;  // tangent of 22.5°, 256ths
  const auto size = [](std::int32_t v) { return v < 0 ? -v : v; };
  if (size(part) * 256 <= size(other) * tangent) return 0;
  return part < 0 ? -1 : 1;
}

}  // namespace

std::uint32_t relief_light::shade(const ShadingGroup& group, std::span<const PackedNormal> normals,
                                  std::size_t number) {
  if (normals.empty()) return word(zero);
  std::int32_t sum = 0;  // of all lights; negative where the normal points away from them
  for (unsigned i = 0; i < group.light_count; ++i) sum += group.lights[i].on(normals[number]);
  return word(coded(sum));
}

void shade_vertices_for_relief(const Mesh& mesh, const ShadingGroup& group, std::uint32_t* shades) {
  for (std::size_t i = 0; i < mesh.vertex_count(); ++i) shades[i] = relief_light::shade(group, mesh.vertex_normals, i);
}

void ReliefSurface::set_polygon(const ShadingGroup& shading, std::uint32_t polygon) {
  const Mesh& mesh = *shading.mesh;
  ambient = shading.ambient;
  const Rgb888 own = mesh.polygon_colours.empty() ? group->colour : mesh.polygon_colours[polygon];
  colour = Rgb565::from(own);
  const std::uint16_t* corner = mesh.indices.data() + mesh.first_corner(polygon);
  const auto position = [&](unsigned i) {
    const Vertex32 v = mesh.vertex(corner[i]);
    return Vec3<std::int64_t>{v.x, v.y, v.z};
  };
  const Vec3<std::int64_t> a = position(0), e = position(1) - a, f = position(2) - a;
  const TextureVertex &ta = group->vertices[corner[0]], &tb = group->vertices[corner[1]],
                      &tc = group->vertices[corner[2]];
  // The sides of the polygon are e = ∂s·es + ∂t·et and f = ∂s·fs + ∂t·ft, hence ∂s = (e·ft − f·et) / det and ∂t = (f·es
  // − e·fs) / det. The low bits of texture coordinates are dropped, so that the products fit 62 bits.
  const auto texels = [](std::int32_t to, std::int32_t from) { return (static_cast<std::int64_t>(to) - from) >> 5; };
  std::int64_t es = texels(tb.s, ta.s), et = texels(tb.t, ta.t), fs = texels(tc.s, ta.s), ft = texels(tc.t, ta.t);
  if (es * ft - fs * et < 0) {
    es = -es;
    et = -et;
    fs = -fs;
    ft = -ft;
  }
  const auto tangent = [&](std::int64_t of_e, std::int64_t of_f) {
    return direction_and_length(e.x * of_e + f.x * of_f, e.y * of_e + f.y * of_f, e.z * of_e + f.z * of_f).direction;
  };
  const Vec3<std::int32_t> lights = sum_of_lights(shading);
  along_s = std::clamp<std::int32_t>(along(lights, tangent(ft, -et)), -(2 << 14), 2 << 14);
  along_t = std::clamp<std::int32_t>(along(lights, tangent(-fs, es)), -(2 << 14), 2 << 14);
  turned = 0;
  const Relief& relief = group->pixelwise->relief;
  if (relief.kind == ReliefKind::bump) {
    // Slopes are in 256ths. A slope is half the difference of two heights, which are 255ths of the depth: difference ·
    // depth / 510.
    factor = static_cast<std::int32_t>(relief.depth.raw() / 510);  // 2^16 for a depth of one texel
    return;
  }
  factor = cosine(relief.turn).raw() >> 16;
  const std::int32_t s = along_s, t = along_t;
  const auto length =
      static_cast<std::int64_t>(square_root(static_cast<std::uint64_t>(std::int64_t{s} * s + std::int64_t{t} * t)));
  turned = static_cast<std::int32_t>((length * sine(relief.turn).raw()) >> 30);
  along_s = to_neighbour(s, t);
  along_t = to_neighbour(t, s);
}

std::uint32_t ReliefSurface::light_at(std::uint32_t u, std::uint32_t v, std::int32_t facing) const {
  const Relief& relief = group->pixelwise->relief;
  const HeightMap& map = *relief.heights;
  const std::uint32_t mask_x = (1u << map.log2_width) - 1, mask_y = (1u << map.log2_height) - 1;
  const std::uint32_t x = u >> 16, y = v >> 16;
  const auto height = [&](std::uint32_t at_x, std::uint32_t at_y) {
    return std::int32_t{map.heights[((at_y & mask_y) << map.log2_width) + (at_x & mask_x)]};
  };
  std::int32_t lit = facing;
  if (relief.kind == ReliefKind::bump) {
    const auto slope = [scale = factor](std::int32_t difference) {
      return std::clamp<std::int32_t>(difference * scale >> 8, -512, 512);
    };
    const std::int32_t p = slope(height(x + 1, y) - height(x - 1, y)), q = slope(height(x, y + 1) - height(x, y - 1));
    lit -= (p * along_s + q * along_t) >> 8;
    lit = lit * (shortening[word(p * p + q * q) >> 10] + 1) >> 8;
  } else {
    constexpr std::int32_t step = 8;  // smaller height differences have no effect, 255ths
    const std::int32_t fall = height(x, y) - height(x + word(along_s), y + word(along_t));
    if (fall > step || fall < -step) lit = (lit * factor >> 14) + (fall > 0 ? turned : -turned);
  }
  const std::int32_t sum = ambient + (lit > 0 ? lit << 2 : 0);
  return word(sum > 65535 ? 65535 : sum);
}

LitTexel ReliefSurface::texel(std::uint32_t u, std::uint32_t v, std::uint32_t light_word) const {
  const std::uint32_t amount = light_at(u, v, relief_light::decoded(light_word));
  const Texture* texture = group->texturing.texture;
  if (texture == nullptr) return {colour, amount};
  // Converts texels of the height map to texels of the texture.
  const HeightMap& map = *group->pixelwise->relief.heights;
  const auto scaled = [](std::uint32_t coordinate, unsigned from, unsigned to) {
    const unsigned shift = 16 + from;
    return (shift >= to ? coordinate >> (shift - to) : coordinate) & ((1u << to) - 1);
  };
  const std::uint32_t x = scaled(u, map.log2_width, texture->log2_width),
                      y = scaled(v, map.log2_height, texture->log2_height);
  return {read_texel(*texture, x, y).rgb565, amount};
}

bool ReliefSurface::serves(const Material& material, bool vertex_colours) {
  if (vertex_colours || material.relief.heights == nullptr) return false;
  const Texturing& texturing = material.texturing;
  if (texturing.texture == nullptr) return true;
  return texturing.coordinates == TextureCoordinates::mesh && texturing.function == TextureFunction::modulate &&
         texturing.filter == TextureFilter::nearest && texturing.mip_mapping == MipMapping::none &&
         !texturing.texture->has_alpha() && texturing.texture->wrap_s == Wrap::repeat &&
         texturing.texture->wrap_t == Wrap::repeat;
}

}  // namespace spanline
