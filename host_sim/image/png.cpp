#include "image/png.hpp"

#include <spng.h>

#include <cstdlib>
#include <memory>

#include "base/failure.hpp"

namespace spanline::sim {
namespace {

static_assert(sizeof(Rgb888) == 3 && sizeof(Rgba8888) == 4, "pictures are handed to libspng as they are");

struct Release {
  void operator()(spng_ctx* context) const { spng_ctx_free(context); }
  void operator()(void* memory) const { std::free(memory); }
};

void check(int error) {
  if (error != 0) throw Failure(std::string("PNG: ") + spng_strerror(error));
}

}  // namespace

std::vector<std::byte> encode_png(const Picture& picture) {
  const std::unique_ptr<spng_ctx, Release> context(spng_ctx_new(SPNG_CTX_ENCODER));
  if (!context) throw Failure("PNG: out of memory");
  check(spng_set_option(context.get(), SPNG_ENCODE_TO_BUFFER, 1));
  spng_ihdr header{};
  header.width = static_cast<std::uint32_t>(picture.width);
  header.height = static_cast<std::uint32_t>(picture.height);
  header.color_type = SPNG_COLOR_TYPE_TRUECOLOR;
  header.bit_depth = 8;
  check(spng_set_ihdr(context.get(), &header));
  check(spng_encode_image(context.get(), picture.pixels.data(), picture.pixels.size() * sizeof(Rgb888), SPNG_FMT_PNG,
                          SPNG_ENCODE_FINALIZE));
  std::size_t size = 0;
  int error = 0;
  const std::unique_ptr<void, Release> buffer(spng_get_png_buffer(context.get(), &size, &error));
  check(error);
  const auto* bytes = static_cast<const std::byte*>(buffer.get());
  return {bytes, bytes + size};
}

namespace {

/// `Image` has a width, a height and pixels as `format` writes them.
template <class Image>
Image decode(std::span<const std::byte> bytes, spng_format format) {
  const std::unique_ptr<spng_ctx, Release> context(spng_ctx_new(0));
  if (!context) throw Failure("PNG: out of memory");
  check(spng_set_image_limits(context.get(), greatest_image_side, greatest_image_side));
  check(spng_set_png_buffer(context.get(), bytes.data(), bytes.size()));
  spng_ihdr header{};
  check(spng_get_ihdr(context.get(), &header));
  check_image_size(header.width, header.height);
  Image image;
  image.width = static_cast<int>(header.width);
  image.height = static_cast<int>(header.height);
  image.pixels.resize(std::size_t{header.width} * header.height);
  check(spng_decode_image(context.get(), image.pixels.data(), image.pixels.size() * sizeof(image.pixels[0]), format,
                          SPNG_DECODE_TRNS));
  check(spng_decode_chunks(context.get()));  // to the end: a file that is cut off is refused
  return image;
}

}  // namespace

Picture decode_png(std::span<const std::byte> bytes) { return decode<Picture>(bytes, SPNG_FMT_RGB8); }

ImageRgba decode_png_rgba(std::span<const std::byte> bytes) { return decode<ImageRgba>(bytes, SPNG_FMT_RGBA8); }

}  // namespace spanline::sim
