#include "convert/memory_report.hpp"

#include <array>
#include <cstdio>

#include "convert/board_sizes.hpp"
#include "convert/header_writer.hpp"

namespace spanline::sim {
namespace {

/// Lines of one kind of memory, and their sum.
class Section {
 public:
  explicit Section(const char* memory) : memory_(memory) {}
  void add(const std::string& name, std::size_t bytes) {
    append(name, bytes);
    total_ += bytes;
  }
  [[nodiscard]] std::string finish() {
    append("total", total_);
    return std::move(text_);
  }

 private:
  void append(const std::string& name, std::size_t bytes) {
    std::array<char, 160> buffer{};
    std::snprintf(buffer.data(), buffer.size(), "%-5s  %-44s %9zu bytes\n", memory_, name.c_str(), bytes);
    text_ += buffer.data();
  }

  const char* memory_;
  std::string text_;
  std::size_t total_ = 0;
};

std::string counted(const char* name, std::size_t count) {
  return std::string(name) + " (" + std::to_string(count) + ")";
}

}  // namespace

std::string memory_report(const CoreMesh& mesh, const FrameNeed& need) {
  Section flash("flash");
  for (const TableSize& table : table_sizes(mesh)) flash.add(table.name, table.bytes);
  flash.add("mesh", board::mesh_object);
  Section ram("ram");
  ram.add(counted("vertices", mesh.vertices.size()), mesh.vertices.size() * board::vertex);
  ram.add(counted("shades, for Gouraud shading", mesh.vertices.size()), mesh.vertices.size() * board::shade);
  ram.add(counted("polygons, framed and turned", need.polygons), need.polygons * board::polygon);
  ram.add(counted("active, framed and turned", need.active), need.active * board::active);
  ram.add(counted("instances", 1), board::instance);
  ram.add("320x240 in bands of 16, two of colour", board::bands_of_16);
  return flash.finish() + ram.finish();
}

}  // namespace spanline::sim
