#include "render/displacement_arguments.hpp"

#include "base/failure.hpp"

namespace spanline::sim {

Scene displaced(const Scene& scene, const std::string& model, const DisplacementArguments& arguments) {
  const HeightImage heights = read_heights(arguments.heights);
  try {
    return displaced(scene, heights, arguments.request);
  } catch (const Failure& failure) {
    throw file_failure(model, failure.what());
  }
}

}  // namespace spanline::sim
