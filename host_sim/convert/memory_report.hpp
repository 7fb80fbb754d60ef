#pragma once
#include <cstddef>
#include <string>

#include "convert/board_sizes.hpp"
#include "convert/frame_need.hpp"
#include "scene/core_mesh.hpp"

namespace spanline::sim {

/// Lines of one kind of memory, and their sum.
class MemorySection {
 public:
  explicit MemorySection(const char* memory) : memory_(memory) {}
  void add(const std::string& name, std::size_t bytes);
  [[nodiscard]] std::string finish();

 private:
  void append(const std::string& name, std::size_t bytes);

  const char* memory_;
  std::string text_;
  std::size_t total_ = 0;
};

/// What a frame takes entries for.
struct FrameEntries {
  std::size_t vertices = 0, textured_vertices = 0, instances = 1;
  bool has_fans = false;  ///< any mesh has polygons of more than three corners
};
/// The RAM of a frame, line by line, and its sum.
[[nodiscard]] std::string frame_report(const FrameEntries& entries, const FrameNeed& need);

/// The flash that a mesh takes, and the RAM of a frame that shows it.
[[nodiscard]] std::string memory_report(const CoreMesh& mesh, const FrameNeed& need);

}  // namespace spanline::sim
