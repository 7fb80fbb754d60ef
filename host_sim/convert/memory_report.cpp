#include "convert/memory_report.hpp"

#include <array>
#include <cstdio>

#include "convert/header_writer.hpp"
#include "spanline/raster/texture_vertex.hpp"

namespace spanline::sim {
namespace {

std::string counted(const char* name, std::size_t count) {
  return std::string(name) + " (" + std::to_string(count) + ")";
}

}  // namespace

void MemorySection::add(const std::string& name, std::size_t bytes) {
  append(name, bytes);
  total_ += bytes;
}

std::string MemorySection::finish() {
  append("total", total_);
  return std::move(text_);
}

void MemorySection::append(const std::string& name, std::size_t bytes) {
  std::array<char, 160> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%-5s  %-44s %9zu bytes\n", memory_, name.c_str(), bytes);
  text_ += buffer.data();
}

std::string frame_report(const FrameEntries& entries, const FrameNeed& need) {
  MemorySection ram("ram");
  ram.add(counted("vertices", entries.vertices), entries.vertices * board::vertex);
  ram.add(counted("shades, for Gouraud shading", entries.vertices), entries.vertices * board::shade);
  if (entries.textured_vertices != 0)
    ram.add(counted("textured vertices", entries.textured_vertices), entries.textured_vertices * sizeof(TextureVertex));
  ram.add(counted("polygons, framed and turned", need.polygons), need.polygons * board::polygon);
  if (entries.has_fans) ram.add(counted("fans, framed and turned", need.polygons), need.polygons * board::fan);
  ram.add(counted("active, framed and turned", need.active), need.active * board::active);
  ram.add(counted("instances", entries.instances), entries.instances * board::instance);
  ram.add("320x240 in bands of 16, two of colour", board::bands_of_16);
  return ram.finish();
}

std::string memory_report(const CoreMesh& mesh, const FrameNeed& need) {
  MemorySection flash("flash");
  for (const TableSize& table : table_sizes(mesh)) flash.add(table.name, table.bytes);
  flash.add("mesh", board::mesh_object);
  return flash.finish() + frame_report({.vertices = mesh.vertices.size(), .has_fans = !mesh.corners.empty()}, need);
}

}  // namespace spanline::sim
