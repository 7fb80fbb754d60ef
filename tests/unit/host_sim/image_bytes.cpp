#include "image_bytes.hpp"

#include <spng.h>

#include <cstdio>
#include <cstdlib>
#include <memory>

#include <jpeglib.h>

namespace spanline::sim::test {
namespace {

std::vector<std::byte> taken(void* memory, std::size_t size) {
  const auto* bytes = static_cast<const std::byte*>(memory);
  std::vector<std::byte> result(bytes, bytes + size);
  std::free(memory);
  return result;
}

}  // namespace

std::vector<std::byte> png_with_alpha(const ImageRgba& image) {
  const std::unique_ptr<spng_ctx, void (*)(spng_ctx*)> context(spng_ctx_new(SPNG_CTX_ENCODER), spng_ctx_free);
  spng_set_option(context.get(), SPNG_ENCODE_TO_BUFFER, 1);
  spng_ihdr header{};
  header.width = static_cast<std::uint32_t>(image.width);
  header.height = static_cast<std::uint32_t>(image.height);
  header.color_type = SPNG_COLOR_TYPE_TRUECOLOR_ALPHA;
  header.bit_depth = 8;
  spng_set_ihdr(context.get(), &header);
  spng_encode_image(context.get(), image.pixels.data(), image.pixels.size() * 4, SPNG_FMT_PNG, SPNG_ENCODE_FINALIZE);
  std::size_t size = 0;
  int error = 0;
  void* buffer = spng_get_png_buffer(context.get(), &size, &error);
  return taken(buffer, size);
}

std::vector<std::byte> jpeg_of(const ImageRgba& image) {
  jpeg_compress_struct codec{};
  jpeg_error_mgr errors{};
  codec.err = jpeg_std_error(&errors);
  jpeg_create_compress(&codec);
  unsigned char* buffer = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&codec, &buffer, &size);
  codec.image_width = static_cast<JDIMENSION>(image.width);
  codec.image_height = static_cast<JDIMENSION>(image.height);
  codec.input_components = 3;
  codec.in_color_space = JCS_RGB;
  jpeg_set_defaults(&codec);
  jpeg_set_quality(&codec, 100, TRUE);
  codec.comp_info[0].h_samp_factor = codec.comp_info[0].v_samp_factor = 1;
  jpeg_start_compress(&codec, TRUE);
  std::vector<unsigned char> row;
  for (int y = 0; y < image.height; ++y) {
    row.clear();
    for (int x = 0; x < image.width; ++x) {
      const Rgb888 c = image.at(x, y).colour;
      row.insert(row.end(), {c.red, c.green, c.blue});
    }
    unsigned char* line = row.data();
    jpeg_write_scanlines(&codec, &line, 1);
  }
  jpeg_finish_compress(&codec);
  jpeg_destroy_compress(&codec);
  return taken(buffer, size);
}

}  // namespace spanline::sim::test
