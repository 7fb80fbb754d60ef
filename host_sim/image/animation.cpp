#include "image/animation.hpp"

#include "image/apng.hpp"
#include "image/gif.hpp"

namespace spanline::sim {

std::unique_ptr<AnimationWriter> make_animation(AnimationFormat format, OutputFile& file, int frames) {
  if (format == AnimationFormat::gif) return make_gif(file);
  return make_apng(file, frames);
}

}  // namespace spanline::sim
