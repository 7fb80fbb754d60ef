// libFuzzer's entry: bytes as an image file, which becomes a texture of some format or is refused.
#include <cstdio>
#include <cstdlib>

#include "base/failure.hpp"
#include "image/texture_image.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace spanline;
  if (size == 0) return 0;
  const TexelFormat format = static_cast<TexelFormat>(data[0] % 5);
  const bool mip_map = (data[0] & 64) != 0, resize = (data[0] & 128) != 0;
  const auto* bytes = reinterpret_cast<const std::byte*>(data) + 1;
  try {
    sim::ImageRgba image = sim::decode_image({bytes, bytes + size - 1});
    // What follows takes its time by the pixel.
    if (image.pixels.size() > 1u << 16) return 0;
    const sim::TextureImage texture =
        sim::make_texture(std::move(image), {.format = format, .mip_map = mip_map, .resize = resize});
    if (const TextureFault fault = validate(texture.view()); fault != TextureFault::none) {
      std::fprintf(stderr, "an invalid texture: %s\n", to_string(fault));
      std::abort();
    }
  } catch (const sim::Failure&) {
    // Refused, as it should be.
  }
  return 0;
}
