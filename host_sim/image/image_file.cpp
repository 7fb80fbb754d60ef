#include "image/image_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/failure.hpp"
#include "image/jpeg.hpp"
#include "image/png.hpp"

namespace spanline::sim {
namespace {

/// More than a PNG of 4096 × 4096 pixels takes.
constexpr std::uintmax_t greatest_file = std::uintmax_t{64} << 20;

std::vector<std::byte> read_bytes(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) throw file_failure(path, "is no file that can be read");
  if (std::filesystem::file_size(path, error) > greatest_file) throw file_failure(path, "is too large for an image");
  std::ifstream file(path, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
  if (!file) throw file_failure(path, "cannot be read");
  const auto* data = reinterpret_cast<const std::byte*>(bytes.data());
  return {data, data + bytes.size()};
}

template <std::size_t N>
bool begins_with(const std::vector<std::byte>& bytes, const std::array<unsigned char, N>& magic) {
  return bytes.size() >= N && std::equal(magic.begin(), magic.end(), bytes.begin(),
                                         [](unsigned char a, std::byte b) { return std::byte{a} == b; });
}

}  // namespace

void check_image_size(std::uint64_t width, std::uint64_t height) {
  constexpr std::uint64_t side = greatest_image_side;
  if (width == 0 || height == 0 || width > side || height > side || width * height > most_image_pixels)
    throw Failure("is " + std::to_string(width) + "x" + std::to_string(height) + ", which is too large for an image");
}

ImageRgba decode_image(const std::vector<std::byte>& bytes) {
  if (begins_with(bytes, std::array<unsigned char, 4>{0x89, 'P', 'N', 'G'})) return decode_png_rgba(bytes);
  if (begins_with(bytes, std::array<unsigned char, 3>{0xff, 0xd8, 0xff})) return decode_jpeg(bytes);
  throw Failure(bytes.empty() ? "is empty" : "is neither PNG nor JPEG");
}

ImageRgba read_image(const std::string& path) {
  const std::vector<std::byte> bytes = read_bytes(path);
  try {
    return decode_image(bytes);
  } catch (const Failure& failure) {
    throw file_failure(path, failure.what());
  }
}

bool is_image_name(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending == ".png" || ending == ".jpg" || ending == ".jpeg";
}

}  // namespace spanline::sim
