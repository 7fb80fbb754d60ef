#include "convert/parts_writer.hpp"

#include "convert/flash_mesh.hpp"
#include "convert/header_writer.hpp"
#include "convert/memory_report.hpp"
#include "convert/texture_writer.hpp"

namespace spanline::sim {
namespace {

/// The polygons that the triangles from `begin` to `end` are.
std::vector<std::uint8_t> polygons_between(const Scene& scene, std::size_t begin, std::size_t end) {
  std::vector<std::uint8_t> polygons;
  std::size_t first = 0;
  for (const std::uint8_t count : scene.polygon_triangles) {
    if (first >= begin && first < end) polygons.push_back(count);
    first += count;
  }
  return polygons;
}

/// The triangles of one part, with the vertices that they use.
Scene scene_of_part(const Scene& scene, std::size_t number) {
  const std::size_t begin = scene.parts[number].first;
  const std::size_t end = number + 1 < scene.parts.size() ? scene.parts[number + 1].first : scene.triangles.size();
  const auto cut = [&](const auto& table, auto& out) {
    if (table.empty()) return;
    out.assign(table.begin() + static_cast<std::ptrdiff_t>(begin), table.begin() + static_cast<std::ptrdiff_t>(end));
  };
  Scene part = scene;
  part.parts = {scene.parts[number]};
  part.parts[0].first = 0;
  cut(scene.triangles, part.triangles);
  cut(scene.polygon_normals, part.polygon_normals);
  part.polygon_triangles = polygons_between(scene, begin, end);
  part.polygon_colours.clear();  // the part's colour
  if (part.parts[0].image == Scene::Part::no_image) part.texture_points.clear();
  return welded(part);
}

std::string texture_name(const std::string& name, std::size_t number) {
  return name + "_texture_" + std::to_string(number);
}
std::string mesh_name(const std::string& name, std::size_t number) { return name + "_mesh_" + std::to_string(number); }

std::string colour_text(Rgb888 colour) {
  return "{" + std::to_string(colour.red) + ", " + std::to_string(colour.green) + ", " + std::to_string(colour.blue) +
         "}";
}

/// Without its highlights.
std::string matte_text(const FlashParts& parts, const CoreMesh& mesh, const std::string& name, std::size_t number) {
  const Scene::Part& part = parts.parts[mesh.part];
  const PartTexture& texture = parts.textures.of_part[mesh.part];
  std::string text = "spanline::model_part(" + mesh_name(name, number) + ", " + colour_text(part.colour) +
                     ", spanline::ShadingMode::" + (parts.smooth ? "gouraud" : "flat");
  if (part.opacity == 255 && texture.image == PartTexture::none) return text + ")";
  text += ", " + std::to_string(part.opacity);
  if (texture.image != PartTexture::none)
    text += ", &" + texture_name(name, texture.image) +
            ", spanline::TexelAlpha::" + (texture.alpha == TexelAlpha::blend ? "blend" : "cut_out");
  return text + ")";
}

std::string part_text(const FlashParts& parts, const CoreMesh& mesh, const std::string& name, std::size_t number) {
  const Highlights& highlights = parts.parts[mesh.part].highlights;
  std::string text = matte_text(parts, mesh, name, number);
  if (highlights.shines())
    text = "spanline::shining(" + text + ", " + colour_text(highlights.specular) + ", " +
           std::to_string(highlights.shininess) + ")";
  return "    " + text + ",\n";
}

}  // namespace

FlashParts cut_into_parts(const Scene& scene, const TextureOptions& options, bool format_wanted) {
  FlashParts result;
  result.parts = scene.parts;
  result.textures = load_textures(scene, options, format_wanted);
  result.smooth = scene.normals_from_file;
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    result.meshes.push_back(to_flash_mesh(scene_of_part(scene, i)));
    result.meshes.back().part = i;
  }
  return result;
}

std::string write_parts_header(const FlashParts& parts, const std::string& name, const std::string& source) {
  std::string text = "// Made by `spanline convert --materials` from " + comment_safe(source) + ": " +
                     std::to_string(parts.meshes.size()) + " parts, " + std::to_string(parts.textures.images.size()) +
                     " textures.\n#pragma once\n#include <spanline/model/model_part.hpp>\n\n"
                     "namespace spanline_models {\n\n";
  for (std::size_t i = 0; i < parts.textures.images.size(); ++i)
    text += texture_definition(parts.textures.images[i], texture_name(name, i)) + "\n";
  for (std::size_t i = 0; i < parts.meshes.size(); ++i)
    text += mesh_definition(parts.meshes[i], mesh_name(name, i)) + "\n";
  text += "inline constexpr spanline::ModelPart " + name + "[] = {\n";
  for (std::size_t i = 0; i < parts.meshes.size(); ++i) text += part_text(parts, parts.meshes[i], name, i);
  return text + "};\n\n}  // namespace spanline_models\n";
}

std::string parts_report(const FlashParts& parts, const FrameNeed& need) {
  MemorySection flash("flash");
  for (std::size_t i = 0; i < parts.meshes.size(); ++i) {
    std::size_t bytes = board::mesh_object;
    for (const TableSize& table : table_sizes(parts.meshes[i])) bytes += table.bytes;
    flash.add("mesh " + std::to_string(i), bytes);
  }
  for (std::size_t i = 0; i < parts.textures.images.size(); ++i) {
    const TextureImage& image = parts.textures.images[i];
    flash.add("texture " + std::to_string(i) + ", " + to_string(image.shape.format), image.flash_bytes());
  }
  std::size_t vertices = 0, textured = 0;
  bool has_fans = false;
  for (const CoreMesh& mesh : parts.meshes) {
    vertices += mesh.vertices.size();
    textured += mesh.texture_coordinates.size();
    has_fans |= !mesh.corners.empty();
  }
  return flash.finish() + frame_report({vertices, textured, parts.meshes.size(), has_fans}, need);
}

}  // namespace spanline::sim
