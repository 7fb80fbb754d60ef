#include "render/refusal_text.hpp"

#include "spanline/model/light.hpp"

namespace spanline::sim {

std::string refusal_text(const Status& status) {
  const std::string start = "the renderer refused: ";
  switch (status.fault) {
    case Fault::shader_missing:
      return start + "it has no shader for " + to_string(status.missing);
    case Fault::too_many_lights:
      return start + std::to_string(status.wanted) + " lights of a kind, and a frame takes " +
             std::to_string(Lighting::max_lights);
    case Fault::bad_configuration:
      if (status.pool == Pool::none) break;
      return start + "pool " + to_string(status.pool) + " has at most " + std::to_string(status.wanted) + " entries";
    default:
      break;
  }
  return start + to_string(status.fault);
}

}  // namespace spanline::sim
