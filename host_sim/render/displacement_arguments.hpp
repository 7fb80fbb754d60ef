#pragma once
#include <string>

#include "scene/displacement.hpp"

namespace spanline::sim {

/// What the command line asks of a model's geometry.
struct DisplacementArguments {
  std::string heights;  ///< a file
  DisplacementRequest request;
};

/// A model moved by the heights of a file. Throws Failure that names the file at fault.
[[nodiscard]] Scene displaced(const Scene& scene, const std::string& model, const DisplacementArguments& arguments);

}  // namespace spanline::sim
