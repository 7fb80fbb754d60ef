// A renderer with textures against a depth buffer, drawn to its last row: the loops that templates make of the kernels.
#include <cstddef>
#include <cstdint>
#include <span>

#include "spanline/frame/ready_made_traits.hpp"
#include "spanline/frame/renderer.hpp"

namespace {
using Picture = spanline::Renderer<spanline::TextureTraits<>>;
}

bool draw(Picture& picture, const spanline::Mesh& mesh, const spanline::Material& material, std::uint16_t* out);
bool draw(Picture& picture, const spanline::Mesh& mesh, const spanline::Material& material, std::uint16_t* out) {
  if (!picture.begin({}).ok() || !picture.add(mesh, {}, material).ok()) return false;
  return picture
      .draw([out](const auto& band) {
        for (std::size_t i = 0; i < band.pixels.size(); ++i) out[i] = band.pixels[i];
        return true;
      })
      .ok();
}
