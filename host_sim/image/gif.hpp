#pragma once
#include <memory>

#include "image/animation.hpp"

namespace spanline::sim {

/// Animated GIF: every frame has its own palette, exact if 256 colours are enough.
[[nodiscard]] std::unique_ptr<AnimationWriter> make_gif(OutputFile& file);

}  // namespace spanline::sim
