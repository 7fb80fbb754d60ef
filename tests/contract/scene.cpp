#include "scene.hpp"

#include <algorithm>
#include <sstream>
#include <utility>

namespace spanline::contract {

std::size_t Scene::polygon_count() const {
  std::size_t count = triangles.size();
  for (const Part& part : parts) count += 7 * part.mesh->triangle_count();
  return count;
}

bool Scene::depths_overlap() const {
  if (!parts.empty()) return true;
  constexpr std::int32_t rounding = 4;  // a plane may leave its corners' depths by two units
  std::vector<std::pair<std::int32_t, std::int32_t>> ranges;
  for (const Corners& t : triangles) ranges.push_back(std::minmax({t[0].z, t[1].z, t[2].z}));
  std::sort(ranges.begin(), ranges.end());
  for (std::size_t i = 1; i < ranges.size(); ++i)
    if (ranges[i].first <= ranges[i - 1].second + rounding) return true;
  return false;
}

std::string text_of(const Scene& scene) {
  std::ostringstream text;
  text << scene.width << " x " << scene.height << ", " << scene.triangles.size() << " triangles, " << scene.parts.size()
       << " instances\n";
  if (scene.triangles.size() > 12) return text.str();
  for (const Corners& t : scene.triangles) {
    text << "  {";
    for (const Corner& c : t) text << "Corner{" << c.x << ", " << c.y << ", " << c.z << "}, ";
    text << "},\n";
  }
  return text.str();
}

}  // namespace spanline::contract
