#include "image/gif.hpp"

#include <gif_lib.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/failure.hpp"

namespace spanline::sim {
namespace {

/// A frame in the form of GIF: a palette of 256 and an index a pixel.
struct IndexedFrame {
  std::array<GifColorType, 256> palette{};
  std::vector<GifByteType> indices;
};

/// The frame with its own colours, if they are 256 at most.
std::optional<IndexedFrame> with_exact_palette(const Picture& picture) {
  std::vector<std::uint32_t> colours;
  const auto number = [](Rgb888 c) { return std::uint32_t{c.red} << 16 | std::uint32_t{c.green} << 8 | c.blue; };
  std::vector<bool> seen(1u << 24);
  for (const Rgb888 pixel : picture.pixels) {
    const std::uint32_t colour = number(pixel);
    if (seen[colour]) continue;
    if (colours.size() == 256) return std::nullopt;
    seen[colour] = true;
    colours.push_back(colour);
  }
  std::sort(colours.begin(), colours.end());
  IndexedFrame frame;
  for (std::size_t i = 0; i < colours.size(); ++i) {
    const Rgb888 c = number_pixel(colours[i]);
    frame.palette[i] = {c.red, c.green, c.blue};
  }
  frame.indices.reserve(picture.pixels.size());
  for (const Rgb888 pixel : picture.pixels) {
    const auto place = std::lower_bound(colours.begin(), colours.end(), number(pixel));
    frame.indices.push_back(static_cast<GifByteType>(place - colours.begin()));
  }
  return frame;
}

/// The frame with the 256 colours that giflib's median cut chooses.
IndexedFrame quantised(const Picture& picture) {
  std::array<std::vector<GifByteType>, 3> channels;
  for (const Rgb888 pixel : picture.pixels) {
    channels[0].push_back(pixel.red);
    channels[1].push_back(pixel.green);
    channels[2].push_back(pixel.blue);
  }
  IndexedFrame frame;
  frame.indices.resize(picture.pixels.size());
  int colours = 256;
  if (GifQuantizeBuffer(static_cast<unsigned>(picture.width), static_cast<unsigned>(picture.height), &colours,
                        channels[0].data(), channels[1].data(), channels[2].data(), frame.indices.data(),
                        frame.palette.data()) == GIF_ERROR)
    throw Failure("GIF: out of memory");
  return frame;
}

class GifWriter final : public AnimationWriter {
 public:
  explicit GifWriter(OutputFile& file) : file_(file) {
    int error = 0;
    gif_ = EGifOpen(this, &GifWriter::write, &error);
    if (gif_ == nullptr) throw Failure(std::string("GIF: ") + message(error));
    EGifSetGifVersion(gif_, true);
  }
  ~GifWriter() override {
    int error = 0;
    if (gif_ != nullptr) EGifCloseFile(gif_, &error);
  }
  GifWriter(const GifWriter&) = delete;
  GifWriter& operator=(const GifWriter&) = delete;

  void add(const Picture& picture) override {
    if (!started_) start(picture);
    IndexedFrame frame = with_exact_palette(picture).value_or(IndexedFrame{});
    if (frame.indices.empty()) frame = quantised(picture);
    write_frame_control();
    const std::unique_ptr<ColorMapObject, decltype(&GifFreeMapObject)> map(GifMakeMapObject(256, frame.palette.data()),
                                                                           &GifFreeMapObject);
    check(EGifPutImageDesc(gif_, 0, 0, picture.width, picture.height, false, map.get()));
    const auto width = static_cast<std::size_t>(picture.width);
    for (std::size_t row = 0; row < static_cast<std::size_t>(picture.height); ++row)
      check(EGifPutLine(gif_, frame.indices.data() + row * width, picture.width));
  }

  void finish() override {
    int error = 0;
    const int result = EGifCloseFile(gif_, &error);
    gif_ = nullptr;
    if (!write_error_.empty()) throw Failure(write_error_);
    if (result == GIF_ERROR) throw Failure(std::string("GIF: ") + message(error));
  }

 private:
  static const char* message(int error) {
    const char* text = GifErrorString(error);
    return text != nullptr ? text : "unknown error";
  }

  /// giflib is C: an exception must not pass through it.
  static int write(GifFileType* gif, const GifByteType* bytes, int size) {
    auto* writer = static_cast<GifWriter*>(gif->UserData);
    try {
      writer->file_.write(std::as_bytes(std::span(bytes, static_cast<std::size_t>(size))));
      return size;
    } catch (const Failure& failure) {
      writer->write_error_ = failure.what();
      return 0;
    }
  }

  void check(int result) const {
    if (result != GIF_ERROR) return;
    throw Failure(write_error_.empty() ? std::string("GIF: ") + message(gif_->Error) : write_error_);
  }

  void start(const Picture& picture) {
    started_ = true;
    check(EGifPutScreenDesc(gif_, picture.width, picture.height, 8, 0, nullptr));
    // "NETSCAPE2.0" application block: loop count 0 plays for ever.
    const std::array<unsigned char, 3> loop{1, 0, 0};
    check(EGifPutExtensionLeader(gif_, APPLICATION_EXT_FUNC_CODE));
    check(EGifPutExtensionBlock(gif_, 11, "NETSCAPE2.0"));
    check(EGifPutExtensionBlock(gif_, static_cast<int>(loop.size()), loop.data()));
    check(EGifPutExtensionTrailer(gif_));
  }

  void write_frame_control() const {
    const GraphicsControlBlock control{
        .DisposalMode = DISPOSE_DO_NOT, .UserInputFlag = false, .DelayTime = frame_hundredths, .TransparentColor = -1};
    std::array<GifByteType, 4> bytes{};
    EGifGCBToExtension(&control, bytes.data());
    check(EGifPutExtension(gif_, GRAPHICS_EXT_FUNC_CODE, static_cast<int>(bytes.size()), bytes.data()));
  }

  OutputFile& file_;
  GifFileType* gif_ = nullptr;
  bool started_ = false;
  std::string write_error_;  ///< what stopped `write`, in its own words
};

}  // namespace

std::unique_ptr<AnimationWriter> make_gif(OutputFile& file) { return std::make_unique<GifWriter>(file); }

}  // namespace spanline::sim
