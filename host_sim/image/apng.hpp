#pragma once
#include <memory>

#include "image/animation.hpp"

namespace spanline::sim {

/// Animated PNG (PNG specification, third edition, 11.3, "Animation information"): every frame is encoded by the PNG
/// encoder, and its IDAT chunks are wrapped again as fdAT.
[[nodiscard]] std::unique_ptr<AnimationWriter> make_apng(OutputFile& file, int frames);

}  // namespace spanline::sim
