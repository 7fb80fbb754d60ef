#include "scene.hpp"

#include <sstream>

namespace spanline::contract {

std::size_t Scene::polygon_count() const {
  std::size_t count = triangles.size();
  for (const Part& part : parts) count += 7 * part.mesh->triangle_count();
  return count;
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
