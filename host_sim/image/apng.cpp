#include "image/apng.hpp"

#include <zlib.h>

#include <array>
#include <string_view>

#include "image/png.hpp"

namespace spanline::sim {
namespace {

using Bytes = std::vector<std::byte>;

void append_u32(Bytes& bytes, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<std::byte>(value >> shift));
}

void append_u16(Bytes& bytes, std::uint32_t value) {
  bytes.push_back(static_cast<std::byte>(value >> 8));
  bytes.push_back(static_cast<std::byte>(value));
}

std::uint32_t read_u32(std::span<const std::byte> bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | std::to_integer<std::uint32_t>(bytes[i]);
  return value;
}

/// A chunk as it stands in a PNG file: length, type, data, CRC of type and data.
Bytes chunk(std::string_view type, std::span<const std::byte> data) {
  Bytes bytes;
  append_u32(bytes, static_cast<std::uint32_t>(data.size()));
  for (const char letter : type) bytes.push_back(static_cast<std::byte>(letter));
  bytes.insert(bytes.end(), data.begin(), data.end());
  const auto* checked = reinterpret_cast<const Bytef*>(bytes.data() + 4);
  append_u32(bytes, static_cast<std::uint32_t>(crc32(0, checked, static_cast<uInt>(bytes.size() - 4))));
  return bytes;
}

constexpr std::size_t signature_size = 8;
constexpr std::size_t chunk_overhead = 12;

class ApngWriter final : public AnimationWriter {
 public:
  ApngWriter(OutputFile& file, int frames) : file_(file), frames_(static_cast<std::uint32_t>(frames)) {}

  void add(const Picture& frame) override {
    const Bytes png = encode_png(frame);
    std::span<const std::byte> rest(png);
    const bool first = sequence_ == 0;
    if (first) file_.write(rest.first(signature_size));
    rest = rest.subspan(signature_size);
    while (rest.size() >= chunk_overhead) {
      const std::size_t size = read_u32(rest) + chunk_overhead;
      const std::string_view type(reinterpret_cast<const char*>(rest.data()) + 4, 4);
      if (type == "IHDR") {
        if (first) start(rest.first(size));
        write_frame_control(frame);
      } else if (type == "IDAT") {
        write_data(first, rest.first(size));
      }
      rest = rest.subspan(size);
    }
  }

  void finish() override { file_.write(chunk("IEND", {})); }

 private:
  void start(std::span<const std::byte> header) {
    file_.write(header);
    Bytes control;
    append_u32(control, frames_);
    append_u32(control, 0);  // played for ever
    file_.write(chunk("acTL", control));
  }

  void write_frame_control(const Picture& frame) {
    Bytes control;
    append_u32(control, sequence_++);
    append_u32(control, static_cast<std::uint32_t>(frame.width));
    append_u32(control, static_cast<std::uint32_t>(frame.height));
    append_u32(control, 0);  // x offset
    append_u32(control, 0);  // y offset
    append_u16(control, frame_hundredths);
    append_u16(control, 100);
    control.push_back(std::byte{0});  // dispose: leave the frame
    control.push_back(std::byte{0});  // blend: replace
    file_.write(chunk("fcTL", control));
  }

  /// The first frame is the still picture of programs that know no animation: plain IDAT.
  void write_data(bool first, std::span<const std::byte> idat) {
    if (first) {
      file_.write(idat);
      return;
    }
    Bytes data;
    append_u32(data, sequence_++);
    const auto payload = idat.subspan(8, idat.size() - chunk_overhead);
    data.insert(data.end(), payload.begin(), payload.end());
    file_.write(chunk("fdAT", data));
  }

  OutputFile& file_;
  std::uint32_t frames_;
  std::uint32_t sequence_ = 0;
};

}  // namespace

std::unique_ptr<AnimationWriter> make_apng(OutputFile& file, int frames) {
  return std::make_unique<ApngWriter>(file, frames);
}

}  // namespace spanline::sim
