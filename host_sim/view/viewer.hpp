#pragma once
#include <optional>
#include <string>

#include "base/parse.hpp"
#include "scene/scene.hpp"

namespace spanline::sim {

struct ViewerOptions {
  std::string title;                      ///< the model's name
  Size size;                              ///< of the picture
  int frames = 0;                         ///< ends after so many; 0: when the user closes the window
  std::optional<std::string> screenshot;  ///< PNG of the window's content at the end
};

/// Shows the model in a window until it is closed. Throws Failure.
void run_viewer(const Scene& scene, const ViewerOptions& options);

/// The keys and what they do, for --help.
[[nodiscard]] const char* viewer_keys();

}  // namespace spanline::sim
