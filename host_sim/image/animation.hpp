#pragma once
#include <memory>

#include "base/output_file.hpp"
#include "image/picture.hpp"

namespace spanline::sim {

/// Takes the frames of a film one by one and writes them on; `finish` comes once, after the last.
class AnimationWriter {
 public:
  virtual ~AnimationWriter() = default;
  virtual void add(const Picture& frame) = 0;
  virtual void finish() = 0;
};

enum class AnimationFormat { apng, gif };

/// Hundredths of a second that a frame stays, GIF's unit: 25 frames a second.
inline constexpr int frame_hundredths = 4;

/// A writer of `frames` frames of one size, played for ever; `file` outlives it.
[[nodiscard]] std::unique_ptr<AnimationWriter> make_animation(AnimationFormat format, OutputFile& file, int frames);

}  // namespace spanline::sim
