// Writes seeds for fuzz_images into a folder: a byte of options and a small file, PNG and JPEG.
#include <cstdio>
#include <fstream>
#include <string>

#include "image_bytes.hpp"

namespace {

bool write(const std::string& path, char options, const std::vector<std::byte>& bytes) {
  std::ofstream file(path, std::ios::binary);
  file.put(options);
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  return static_cast<bool>(file.flush());
}

}  // namespace

int main(int argc, char** argv) {
  using namespace spanline::sim;
  if (argc != 2) {
    std::fprintf(stderr, "usage: fuzz_image_corpus FOLDER, which must exist\n");
    return 1;
  }
  const std::string folder = argv[1];
  for (int i = 0; i < 10; ++i) {
    ImageRgba image{1 << i % 5, 3 + 2 * i, {}};
    for (int k = 0; k < image.width * image.height; ++k)
      image.pixels.push_back({{static_cast<std::uint8_t>(k * 7), static_cast<std::uint8_t>(k * i), 99},
                              static_cast<std::uint8_t>(k * 31)});
    const auto options = static_cast<char>(i | 192);
    if (!write(folder + "/" + std::to_string(i) + ".png", options, test::png_with_alpha(image)) ||
        !write(folder + "/" + std::to_string(i) + ".jpg", options, test::jpeg_of(image)))
      return 1;
  }
  return 0;
}
