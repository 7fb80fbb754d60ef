#include "image/jpeg.hpp"

#include <array>
#include <csetjmp>
#include <cstdio>
#include <string>

#include <jpeglib.h>

#include "base/failure.hpp"

namespace spanline::sim {
namespace {

/// libjpeg ends in `error_exit`, which must not return: it jumps to where reading began.
struct Reader {
  jpeg_decompress_struct codec{};
  jpeg_error_mgr errors{};
  std::jmp_buf back{};
  std::array<char, JMSG_LENGTH_MAX> message{};

  Reader() {
    codec.err = jpeg_std_error(&errors);
    codec.client_data = this;
    errors.error_exit = [](j_common_ptr common) {
      auto* reader = static_cast<Reader*>(common->client_data);
      reader->errors.format_message(common, reader->message.data());
      std::longjmp(reader->back, 1);
    };
    // A warning is damage that libjpeg would paint over.
    errors.emit_message = [](j_common_ptr common, int level) {
      if (level < 0) common->err->error_exit(common);
    };
  }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
  ~Reader() { jpeg_destroy_decompress(&codec); }
};

/// Whether libjpeg found nothing amiss. Nothing with a destructor may live in here: it is left by a jump.
bool read(Reader& reader, std::span<const std::byte> bytes, ImageRgba& image, std::vector<unsigned char>& row) {
  if (setjmp(reader.back) != 0) return false;
  jpeg_decompress_struct& codec = reader.codec;
  jpeg_create_decompress(&codec);
  jpeg_mem_src(&codec, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  jpeg_read_header(&codec, TRUE);
  check_image_size(codec.image_width, codec.image_height);
  codec.out_color_space = JCS_RGB;
  jpeg_start_decompress(&codec);
  image.width = static_cast<int>(codec.output_width);
  image.height = static_cast<int>(codec.output_height);
  image.pixels.reserve(std::size_t{codec.output_width} * codec.output_height);
  row.resize(std::size_t{codec.output_width} * 3);
  while (codec.output_scanline < codec.output_height) {
    unsigned char* line = row.data();
    jpeg_read_scanlines(&codec, &line, 1);
    for (std::size_t i = 0; i < row.size(); i += 3) image.pixels.push_back({{row[i], row[i + 1], row[i + 2]}, 255});
  }
  jpeg_finish_decompress(&codec);
  return true;
}

}  // namespace

ImageRgba decode_jpeg(std::span<const std::byte> bytes) {
  Reader reader;
  ImageRgba image;
  std::vector<unsigned char> row;
  if (!read(reader, bytes, image, row)) throw Failure(std::string("JPEG: ") + reader.message.data());
  return image;
}

}  // namespace spanline::sim
