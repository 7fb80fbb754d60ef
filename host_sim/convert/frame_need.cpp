#include "convert/frame_need.hpp"

#include <algorithm>

#include "render/frame.hpp"

namespace spanline::sim {
namespace {

constexpr int sides = 24;

std::size_t peak(const FrameStatistics& statistics, const char* name) {
  for (const auto& [pool, bytes] : statistics.peak_bytes)
    if (pool == name) return static_cast<std::size_t>(bytes);
  return 0;
}

}  // namespace

FrameNeed measure_need(Scene scene) {
  scene.polygon_triangles.clear();
  FrameRequest request;
  request.visibility = &find_visibility("scanline-z");
  const View home = resolve_view({}, scene, request.size, true);
  const World world = choose_world(home, scene, request.size);
  FrameRenderer renderer(to_core_meshes(scene, world));
  FrameNeed need;
  for (int side = 0; side < sides; ++side) {
    request.camera = to_camera(turned(home, static_cast<double>(side) / sides), world, request.size);
    const Frame frame = renderer.draw(request);
    need.polygons =
        std::max(need.polygons, peak(frame.statistics, "polygons") / FrameRenderer::entry_size(&Capacity::polygons));
    need.active =
        std::max(need.active, peak(frame.statistics, "active") / FrameRenderer::entry_size(&Capacity::active));
  }
  return need;
}

}  // namespace spanline::sim
