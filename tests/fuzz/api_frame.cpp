#include "api_frame.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "byte_reader.hpp"
#include "sizes.hpp"
#include "spanline/model/planarity.hpp"
#include "spanline/model/validate.hpp"
#include "support/random.hpp"

namespace spanline::fuzz {
namespace {

constexpr int most_columns = 72, most_rows = 48;
constexpr std::size_t most_parts = 5, most_polygons = 24, most_submissions = 8;

template <class Enumeration>
Enumeration any_of(ByteReader& reader, Enumeration last) {
  return static_cast<Enumeration>(reader.byte() % (static_cast<int>(last) + 1));
}
std::uint8_t any_byte(ByteReader& reader) { return static_cast<std::uint8_t>(reader.byte()); }
Rgb888 any_colour(ByteReader& reader) { return {any_byte(reader), any_byte(reader), any_byte(reader)}; }

/// Of any size, small ones most often.
Q16_16 any_number(ByteReader& reader) {
  const int shift = reader.byte() % 24;
  return Q16_16::from_raw(reader.full_word() >> shift);
}
/// In [low, high], in steps of 1/256.
Q16_16 number_between(ByteReader& reader, int low, int high) {
  return Q16_16::from_raw(reader.between(low * 256, high * 256) * 256);
}
/// Up to `most`, seldom one too many.
int any_count(ByteReader& reader, int most) { return reader.chance(16) ? most + 1 : reader.byte() % (most + 1); }
Position any_position(ByteReader& reader) { return {any_number(reader), any_number(reader), any_number(reader)}; }
Position near_position(ByteReader& reader) {
  return {number_between(reader, -4, 4), number_between(reader, -4, 4), number_between(reader, -8, 2)};
}
Angle any_angle(ByteReader& reader) { return Angle::from_raw(static_cast<std::uint32_t>(reader.half_word()) << 16); }
Rotation any_rotation(ByteReader& reader) {
  return rotation_x(any_angle(reader)) * rotation_y(any_angle(reader)) * rotation_z(any_angle(reader));
}

Capacity any_capacity(ByteReader& reader) {
  Capacity c;
  c.width = static_cast<std::uint16_t>(reader.between(1, most_columns));
  c.height = static_cast<std::uint16_t>(reader.between(1, most_rows));
  c.band_lines = static_cast<std::uint16_t>(reader.between(1, c.height));
  c.colour_bands = static_cast<std::uint8_t>(reader.between(1, 3));
  c.depth_bands = static_cast<std::uint8_t>(reader.between(1, 2));
  const int tight = reader.byte();  // bit by bit: pools that are small
  std::uint32_t* const pools[] = {&c.instances, &c.vertices, &c.shades, &c.textures,
                                  &c.polygons,  &c.fans,     &c.active, &c.layers};
  for (std::size_t i = 0; i < std::size(pools); ++i)
    *pools[i] = (tight >> i & 1) != 0 ? static_cast<std::uint32_t>(reader.byte() % 40) : 1500;
  c.instances = std::min<std::uint32_t>(c.instances, 40);  // each takes much memory
  c.awake = c.members = c.active;
  c.fragments = c.layers * 8;
  if (reader.chance(24)) c.width = static_cast<std::uint16_t>(reader.half_word());
  if (reader.chance(24)) c.band_lines = static_cast<std::uint16_t>(reader.byte());
  if (reader.chance(24)) c.depth_bands = any_byte(reader);
  if (reader.chance(16)) {  // more than there is memory for, or more than can be numbered
    std::uint32_t* const sizes[] = {&c.instances, &c.vertices, &c.shades,    &c.textures, &c.polygons, &c.fans,
                                    &c.active,    &c.awake,    &c.fragments, &c.layers,   &c.members};
    *sizes[static_cast<std::size_t>(reader.byte()) % std::size(sizes)] =
        reader.chance(2) ? ~0u : static_cast<std::uint32_t>(reader.full_word());
  }
  return c;
}

void set_camera(ByteReader& reader, Camera& camera) {
  camera.projection = any_of(reader, Projection::orthographic);
  const bool wild = reader.chance(6);
  camera.focal = wild ? any_number(reader) : number_between(reader, 8, 120);
  camera.near_plane = wild ? any_number(reader) : number_between(reader, 0, 4);
  camera.far_plane = wild ? any_number(reader) : number_between(reader, 4, 100);
  camera.eye = wild ? any_position(reader) : Position{};
  if (reader.chance(2)) camera.axes = any_rotation(reader);
}

void set_settings(ByteReader& reader, ApiFrame& frame) {
  FrameSettings& s = frame.settings;
  set_camera(reader, s.camera);
  s.background = any_colour(reader);
  s.cull = any_of(reader, Cull::none);
  s.stipple_seed = static_cast<std::uint8_t>(reader.byte() & 127);
  s.dither = reader.chance(3);
  if (reader.chance(3)) {
    const Q16_16 start = number_between(reader, -4, 8);
    s.fog = {any_of(reader, FogCurve::exponential), start,
             Q16_16::from_raw(start.raw() + 1 + (reader.half_word() & 0xffff) * 32), any_colour(reader)};
  }
  s.lighting.ambient = Fixed<16>::from_raw(reader.between(0, 65535) + reader.byte() % 2);
  for (int i = any_count(reader, Lighting::max_lights); i > 0; --i)
    frame.lights.push_back({any_rotation(reader).row[2], Fixed<16>::from_raw(reader.between(0, 65535) * 4)});
  if (reader.chance(3))
    for (int i = any_count(reader, Lighting::max_lights); i > 0; --i)
      frame.point_lights.push_back({near_position(reader), Fixed<16>::from_raw(reader.between(0, 65535) * 4),
                                    reader.chance(2) ? Q16_16{} : number_between(reader, 1, 20)});
  s.lighting.lights = frame.lights;
  s.lighting.point_lights = frame.point_lights;
}

PackedNormal any_normal(ByteReader& reader) {
  return {reader.between(-511, 511), reader.between(-511, 511), reader.between(-511, 511)};
}

/// Anything at all, valid or not.
void spoil(ByteReader& reader, contract::OwnedMesh& mesh) {
  switch (reader.byte() % 8) {
    case 0:
      mesh.indices.push_back(static_cast<std::uint16_t>(reader.half_word()));
      break;
    case 1:
      mesh.step_exponent = static_cast<std::int8_t>(reader.byte());
      break;
    case 2:
      mesh.texture_exponent = static_cast<std::int8_t>(reader.byte());
      break;
    case 3:
      mesh.bounds.radius = static_cast<std::uint32_t>(reader.full_word());
      break;
    case 4:
      mesh.offset.x = reader.full_word();
      break;
    case 5:
      mesh.corners.push_back(any_byte(reader));
      break;
    case 6:
      mesh.vertex_colours.push_back(any_colour(reader));
      break;
    default:
      mesh.wide_vertices.push_back({reader.full_word(), reader.full_word(), reader.full_word()});
      break;
  }
}

/// Marks the polygons that may be marked.
void mark_planar(contract::OwnedMesh& mesh) {
  const Mesh view = mesh.view();
  for (std::size_t i = 0; i < mesh.corners.size(); ++i)
    if (planarity_of(view, i, view.first_corner(i)) == Planarity::planar) mesh.corners[i] |= Mesh::planar;
}

template <class T, class Make>
void fill(ByteReader& reader, std::vector<T>& table, std::size_t count, int one_in, Make make) {
  if (!reader.chance(one_in)) return;
  for (std::size_t i = 0; i < count; ++i) table.push_back(make(reader));
}

contract::OwnedMesh any_mesh(ByteReader& reader) {
  contract::OwnedMesh mesh;
  const auto vertices = static_cast<std::size_t>(reader.between(3, 16));
  const bool wide = reader.chance(4);
  const int shift = reader.byte() % 12, wide_shift = 1 + reader.byte() % 24;
  for (std::size_t i = 0; i < vertices; ++i) {
    const auto short_one = [&] { return static_cast<std::int16_t>(reader.half_word() >> shift); };
    const auto wide_one = [&] { return reader.full_word() >> wide_shift; };
    if (wide)
      mesh.wide_vertices.push_back({wide_one(), wide_one(), wide_one()});
    else
      mesh.vertices.push_back({short_one(), short_one(), short_one()});
  }
  const auto polygons = static_cast<std::size_t>(reader.byte()) % most_polygons + 1;
  const bool fans = reader.chance(3);
  for (std::size_t p = 0; p < polygons; ++p) {
    const int corners = fans ? reader.between(3, 8) : 3;
    for (int c = 0; c < corners; ++c)
      mesh.indices.push_back(static_cast<std::uint16_t>(static_cast<std::size_t>(reader.byte()) % vertices));
    if (fans) mesh.corners.push_back(static_cast<std::uint8_t>(corners));
  }
  fill(reader, mesh.polygon_normals, polygons, 2, any_normal);
  fill(reader, mesh.vertex_normals, vertices, 2, any_normal);
  fill(reader, mesh.polygon_colours, polygons, 3, any_colour);
  fill(reader, mesh.vertex_colours, vertices, 3, any_colour);
  fill(reader, mesh.vertex_opacities, vertices, 4, any_byte);
  fill(reader, mesh.texture_coordinates, vertices, 2, [](ByteReader& r) {
    return TextureCoordinate{static_cast<std::int16_t>(r.half_word()), static_cast<std::int16_t>(r.half_word())};
  });
  mesh.texture_exponent = static_cast<std::int8_t>(reader.between(-20, -5));
  const int reach = wide ? 31 - wide_shift : 15 - shift;
  mesh.step_exponent = static_cast<std::int8_t>(std::clamp(-reach + reader.between(-2, 2), -30, 14));
  if (reader.chance(4)) mesh.offset = {reader.half_word(), reader.half_word(), reader.half_word()};
  mesh.fit_bounds();
  if (reader.chance(2)) mark_planar(mesh);
  if (reader.chance(8)) spoil(reader, mesh);
  return mesh;
}

const Texture& any_texture(ByteReader& reader, ApiFrame& frame) {
  test::Random texels(static_cast<std::uint32_t>(reader.byte()));
  const auto format = any_of(reader, TexelFormat::palette256);
  const auto side = [&] { return static_cast<unsigned>(reader.chance(10) ? reader.byte() % 11 : reader.byte() % 6); };
  const unsigned log2_width = side(), log2_height = std::min(side(), 16 - log2_width);
  frame.textures.emplace_back(texels, format, log2_width, log2_height, reader.chance(2));
  Texture& texture = frame.textures.back().texture;
  texture.wrap_s = any_of(reader, Wrap::clamp);
  texture.wrap_t = any_of(reader, Wrap::clamp);
  return texture;
}

/// Entries of the matrix leave coordinates below 2,048 textures, as its header asks.
void lay_texture(ByteReader& reader, ApiFrame& frame, const contract::OwnedMesh& mesh, Material& material) {
  material.texturing = {.texture = &any_texture(reader, frame),
                        .function = any_of(reader, TextureFunction::blend),
                        .filter = any_of(reader, TextureFilter::bilinear),
                        .mapping = any_of(reader, TextureMapping::affine),
                        .mip_mapping = any_of(reader, MipMapping::span),
                        .alpha = any_of(reader, TexelAlpha::blend),
                        .blend_colour = any_colour(reader),
                        .coordinates = any_of(reader, TextureCoordinates::sphere_map)};
  // |s|, |t| ≤ 2^(15 + exponent) textures: two factors of at most 2^most · 15/16 each, and offsets below 1.
  const int most = std::clamp(-5 - mesh.texture_exponent, 0, 10);
  TextureMatrix& matrix = material.texture_matrix;
  for (Q16_16* factor : {&matrix.ss, &matrix.st, &matrix.ts, &matrix.tt})
    *factor = Q16_16::from_raw(reader.half_word() * 15 / 8 * (1 << most));
  for (Q16_16* offset : {&matrix.s0, &matrix.t0}) *offset = Q16_16::from_raw(reader.half_word());
}

void set_relief(ByteReader& reader, ApiFrame& frame, Material& material) {
  contract::SurfaceTables& tables = frame.tables.emplace_back();
  for (int i = 0; i < 8 * 4; ++i) tables.bytes.push_back(any_byte(reader));
  tables.heights = {3, 2, tables.bytes};
  material.relief = {.heights = &tables.heights,
                     .kind = any_of(reader, ReliefKind::emboss),
                     .depth = Fixed<16>::from_raw(1 + (reader.half_word() & 0xffff) * 64),
                     .turn = Angle::from_degrees(reader.between(1, 89))};
}

void set_solid(ByteReader& reader, ApiFrame& frame, Material& material) {
  contract::SurfaceTables& tables = frame.tables.emplace_back();
  test::Random cells(static_cast<std::uint32_t>(reader.byte()));
  for (int i = 0; i < 4 * 4 * 4; ++i) tables.bytes.push_back(static_cast<std::uint8_t>(cells.between(0, 255)));
  for (int i = 0; i < 256; ++i) tables.words.push_back(static_cast<std::uint16_t>(cells.between(0, 65535)));
  tables.solid = {2, tables.bytes, tables.words};
  material.volume = {.source = SolidSource::table,
                     .texture = &tables.solid,
                     .scale = number_between(reader, -4, 4),
                     .exponent = static_cast<std::int8_t>(reader.between(-2, 4))};
}

Material any_material(ByteReader& reader, ApiFrame& frame, const contract::OwnedMesh& mesh) {
  Material material;
  material.colour = any_colour(reader);
  material.shading = any_of(reader, ShadingMode::gouraud);
  const int kinds = reader.byte();
  if ((kinds & 1) != 0) lay_texture(reader, frame, mesh, material);
  if ((kinds & 12) == 4) set_relief(reader, frame, material);
  if ((kinds & 12) == 8) set_solid(reader, frame, material);
  if ((kinds & 48) == 16) material.specular = any_colour(reader);
  material.shininess = static_cast<std::uint8_t>(reader.between(1, 128));
  if ((kinds & 64) != 0) {
    material.opacity = any_byte(reader);
    material.transparency = any_of(reader, Transparency::stochastic);
  }
  return material;
}

void add_part(ByteReader& reader, ApiFrame& frame) {
  contract::OwnedMesh mesh = any_mesh(reader);
  if (!validate(mesh.view()).ok()) return;
  const Material material = any_material(reader, frame, mesh);
  Transform transform;
  transform.rotation = any_rotation(reader);
  const bool wild = reader.chance(8);
  transform.scale = Fixed<24>::from_raw(wild ? 1 + (reader.full_word() & 0x7ffffffe) : 1 << reader.between(21, 26));
  transform.translation = wild ? any_position(reader) : near_position(reader);
  frame.owned.push_back(std::move(mesh));
  frame.meshes.push_back(frame.owned.back().view());
  frame.parts.push_back({&frame.meshes.back(), transform, material});
}

PolygonRange any_range(ByteReader& reader, const Mesh& mesh) {
  const auto all = static_cast<int>(PolygonRange::whole(mesh).count);
  if (reader.chance(12)) {
    const auto first = static_cast<std::uint32_t>(all) + any_byte(reader);
    return {first, 1u + any_byte(reader), 3 * first, first};
  }
  const int first = reader.between(0, all), count = reader.between(0, all - first);
  return PolygonRange::of(mesh, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(count));
}

/// Parts, and polygons of them, in any sequence, some of them twice and some never.
void set_order(ByteReader& reader, ApiFrame& frame) {
  const std::size_t count = static_cast<std::size_t>(reader.byte()) % (most_submissions + 1);
  for (std::size_t i = 0; i < count; ++i) {
    const auto part = static_cast<std::uint32_t>(reader.between(0, most_parts - 1));
    const bool whole = part >= frame.parts.size() || reader.chance(2);
    frame.order.push_back({part, whole, whole ? PolygonRange{} : any_range(reader, *frame.parts[part].mesh)});
  }
}

contract::Corner any_corner(ByteReader& reader) {
  const int shift = reader.byte() % 8;
  const int x = reader.half_word() >> shift, y = reader.half_word() >> shift;
  return contract::corner_near(x, y, reader.full_word() & 0xffffff);
}

/// A convex polygon about any point, mostly of the picture, whose corners lie in one plane or near it, unless the guard
/// band or the range of depths cuts one off.
void append_flat_polygon(ByteReader& reader, const Capacity& picture, int count,
                         std::vector<contract::Corner>& corners) {
  static constexpr std::array<std::array<int, 2>, Mesh::max_corners> octagon{
      {{10, 4}, {4, 10}, {-4, 10}, {-10, 4}, {-10, -4}, {-4, -10}, {4, -10}, {10, -4}}};
  contract::Corner middle = any_corner(reader);
  if (!reader.chance(4)) {
    middle.x = reader.between(0, picture.width * 16);
    middle.y = reader.between(0, picture.height * 16);
  }
  const int size = reader.between(1, 200), across = reader.half_word() / 4, down = reader.half_word() / 4;
  const int off = reader.byte() % 64;
  const bool backwards = reader.chance(2);
  const int first = reader.byte() % 8;
  for (int i = 0; i < count; ++i) {
    const auto& [x, y] = octagon[static_cast<std::size_t>(first + (backwards ? count - 1 - i : i)) % octagon.size()];
    const std::int64_t depth = middle.z + std::int64_t{x} * across + std::int64_t{y} * down + (i == 0 ? off : 0);
    corners.push_back(contract::corner_near(middle.x + x * size, middle.y + y * size, depth));
  }
}

/// Counts that are not those of the corners.
void spoil_corners(ByteReader& reader, std::vector<std::uint8_t>& counts) {
  if (reader.chance(2))
    counts.push_back(any_byte(reader));
  else
    counts.front() = any_byte(reader);
}

/// Triangles, or polygons with their corner counts.
void add_screen_polygons(ByteReader& reader, ApiFrame& frame) {
  const auto polygons = static_cast<std::size_t>(reader.byte() % 12);
  const bool counted = reader.chance(2);
  std::vector<contract::Corner> corners;
  for (std::size_t i = 0; i < polygons; ++i) {
    const int count = counted ? reader.between(3, Mesh::max_corners) : 3;
    if (counted && !reader.chance(3))
      append_flat_polygon(reader, frame.capacity, count, corners);
    else
      for (int c = 0; c < count; ++c) corners.push_back(any_corner(reader));
    if (counted)
      frame.screen_corners.push_back(static_cast<std::uint8_t>(count | (reader.chance(4) ? 0 : Mesh::planar)));
    frame.screen_colours.push_back(static_cast<std::uint16_t>(reader.half_word()));
  }
  for (const contract::Corner& corner : corners)
    frame.screen_vertices.push_back(test::vertex_of(corner, 24, frame.capacity.width, frame.capacity.height));
  if (!frame.screen_corners.empty() && reader.chance(8)) {
    spoil_corners(reader, frame.screen_corners);
    frame.screen_colours.push_back(0);
  }
  if (reader.chance(2)) {
    frame.screen_material.opacity = any_byte(reader);
    frame.screen_material.transparency = any_of(reader, Transparency::stochastic);
  }
}

}  // namespace

ApiFrame decode_frame(std::span<const std::uint8_t> bytes) {
  ByteReader reader(bytes);
  ApiFrame frame;
  frame.capacity = any_capacity(reader);
  frame.other_lines = static_cast<std::uint16_t>(reader.between(1, std::max<int>(1, frame.capacity.height)));
  const int faults = reader.byte();  // a few of which go on to say more
  if (faults % 16 == 1) frame.bytes_missing = static_cast<std::size_t>(reader.between(1, 4000));
  if (faults % 16 == 2) frame.sink_fails_at = static_cast<unsigned>(1 + reader.byte() % 8);
  frame.without_begin = faults % 64 == 3;
  frame.too_many_triangles = faults % 16 == 4;
  frame.in_order = faults % 16 >= 12;
  frame.picked_column = static_cast<std::uint16_t>(reader.between(0, frame.capacity.width * 9 / 8));
  frame.picked_row = static_cast<std::uint16_t>(reader.between(0, frame.capacity.height * 9 / 8));
  frame.misaligned = static_cast<unsigned>(reader.byte() % 8);
  set_settings(reader, frame);
  if (reader.chance(3)) add_screen_polygons(reader, frame);
  ByteReader order = reader;  // the bytes of the parts once more, which leave none
  while (!reader.empty() && frame.parts.size() < most_parts) add_part(reader, frame);
  if (frame.in_order) set_order(order, frame);
  return frame;
}

}  // namespace spanline::fuzz
