#include "convert/memory_report.hpp"

#include <array>
#include <cstdio>

#include "convert/header_writer.hpp"
#include "spanline/frame/renderer.hpp"

namespace spanline::sim {
namespace {

/// The renderer of small boards: 16-bit depth, RGB565, all shadings.
using BoardTraits = FullTraits<>;

std::string line(const char* memory, const std::string& name, std::size_t bytes) {
  std::array<char, 128> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%-5s  %-24s %9zu bytes\n", memory, name.c_str(), bytes);
  return buffer.data();
}

/// The pools that this mesh alone may fill, whatever the camera; clipped pieces apart.
Capacity pools(const CoreMesh& mesh) {
  Capacity capacity;
  capacity.vertices = static_cast<std::uint32_t>(mesh.vertices.size());
  capacity.shades = capacity.vertices;
  capacity.polygons = static_cast<std::uint32_t>(mesh.indices.size() / 3);
  capacity.active = capacity.polygons;
  return capacity;
}

}  // namespace

std::string memory_report(const CoreMesh& mesh) {
  std::string text;
  std::size_t flash = sizeof(Mesh);
  for (const TableSize& table : table_sizes(mesh)) {
    text += line("flash", table.name, table.bytes);
    flash += table.bytes;
  }
  text += line("flash", "mesh object (this host)", sizeof(Mesh));
  text += line("flash", "total", flash);
  const Capacity whole = pools(mesh);
  const auto bytes = [](const Capacity& capacity) { return Renderer<BoardTraits>::bytes_needed(capacity); };
  const auto difference = [&](const char* name, std::uint32_t Capacity::*pool) {
    Capacity without = whole;
    without.*pool = 0;
    text += line("ram", name, bytes(whole) - bytes(without));
  };
  difference("vertices", &Capacity::vertices);
  difference("shades (Gouraud only)", &Capacity::shades);
  difference("polygons", &Capacity::polygons);
  difference("active (at most)", &Capacity::active);
  Capacity none = whole;
  none.vertices = none.shades = none.polygons = none.active = 0;
  text += line("ram", "320x240, bands of 16", bytes(none));
  text += line("ram", "total (at most)", bytes(whole));
  return text;
}

}  // namespace spanline::sim
