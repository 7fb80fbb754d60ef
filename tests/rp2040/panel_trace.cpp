// What a display showed, from the trace of its wires that the emulator of the Pico wrote (pico.mjs): the bytes go to
// the panel's model at their times, with the levels of D/C and chip select.
//
//     panel_trace PANEL TRACE [--pictures PREFIX] [--animation FILE]
//
// A picture is complete when the next one begins (memory write, 2Ch) or the trace ends: PREFIX0.png, PREFIX1.png and so
// on, and an animation (GIF or APNG by its ending). Prints how many pictures there were, and the model's complaints;
// exit 1 if one of them is a failure.
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/output_file.hpp"
#include "image/animation.hpp"
#include "image/png.hpp"
#include "panels/panel_registry.hpp"

namespace {

using namespace spanline::sim;

enum class Kind : std::uint8_t { byte, reset, clock, read, backlight };

struct Record {
  double time;  ///< nanoseconds; of Kind::clock the serial clock in hertz
  Kind kind;
  std::uint8_t levels, value, nothing;

  [[nodiscard]] bool is_data() const { return (levels & 1) != 0; }
  [[nodiscard]] bool is_selected() const { return (levels & 2) != 0; }
  [[nodiscard]] bool reset_is_low() const { return (levels & 4) == 0; }
};
constexpr std::size_t record_size = 12;
constexpr std::uint8_t memory_write = 0x2C;

std::vector<Record> read_trace(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::vector<char> bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  if (!file || bytes.empty() || bytes.size() % record_size != 0) throw std::runtime_error(path + " is not a trace");
  std::vector<Record> records(bytes.size() / record_size);
  for (std::size_t i = 0; i < records.size(); ++i) {
    const char* from = bytes.data() + i * record_size;
    std::memcpy(&records[i].time, from, sizeof(double));
    std::memcpy(&records[i].kind, from + sizeof(double), record_size - sizeof(double));
  }
  return records;
}

Picture to_picture(const PanelPicture& seen) {
  Picture picture(seen.width, seen.height);
  std::memcpy(picture.pixels.data(), seen.rgb.data(), seen.rgb.size());
  return picture;
}

/// Feeds the model and calls `complete(picture)` for each picture.
template <class Complete>
void replay(PanelModel& model, const std::vector<Record>& records, Complete complete) {
  bool has_pixels = false, writing = false;
  for (const Record& record : records) {
    const auto now_ns = static_cast<std::uint64_t>(record.time);
    switch (record.kind) {
      case Kind::reset:
        model.reset_line(record.reset_is_low(), now_ns);
        has_pixels = has_pixels && !record.reset_is_low();
        break;
      case Kind::clock:
        model.set_clock(static_cast<std::uint32_t>(record.time), 0);
        break;
      case Kind::read:
        break;
      case Kind::backlight:
        model.backlight_line(record.value != 0, now_ns);
        break;
      case Kind::byte:
        if (!record.is_selected()) throw std::runtime_error("a byte while the display was not selected");
        if (!record.is_data()) {
          writing = record.value == memory_write;
          if (writing && has_pixels) complete(to_picture(model.picture()));
          has_pixels = has_pixels && !writing;
        }
        model.byte(record.is_data(), record.value, now_ns);
        has_pixels = has_pixels || (writing && record.is_data());
        break;
    }
  }
  model.end_of_stream();
  if (has_pixels) complete(to_picture(model.picture()));
}

void write_picture(const std::string& path, const Picture& picture) {
  OutputFile file(path);
  file.write(encode_png(picture));
  file.commit();
}

void write_animation(const std::string& path, const std::vector<Picture>& pictures) {
  OutputFile file(path);
  const AnimationFormat format = path.ends_with(".gif") ? AnimationFormat::gif : AnimationFormat::apng;
  const auto animation = make_animation(format, file, static_cast<int>(pictures.size()));
  for (const Picture& picture : pictures) animation->add(picture);
  animation->finish();
  file.commit();
}

struct Arguments {
  std::string panel, trace, pictures, animation;
};

Arguments parse(int count, char** words) {
  Arguments arguments;
  if (count < 3) throw std::runtime_error("usage: panel_trace PANEL TRACE [--pictures P] [--animation F]");
  arguments.panel = words[1];
  arguments.trace = words[2];
  for (int i = 3; i + 1 < count; i += 2) {
    const std::string option = words[i], value = words[i + 1];
    if (option == "--pictures") arguments.pictures = value;
    if (option == "--animation") arguments.animation = value;
  }
  return arguments;
}

int run(const Arguments& arguments) {
  const auto model = make_panel_model(arguments.panel);
  if (model == nullptr) throw std::runtime_error("no panel " + arguments.panel);
  std::vector<Picture> pictures;
  replay(*model, read_trace(arguments.trace), [&](Picture picture) { pictures.push_back(std::move(picture)); });
  for (std::size_t i = 0; !arguments.pictures.empty() && i < pictures.size(); ++i)
    write_picture(arguments.pictures + std::to_string(i) + ".png", pictures[i]);
  if (!arguments.animation.empty() && !pictures.empty()) write_animation(arguments.animation, pictures);
  std::printf("%zu pictures\n", pictures.size());
  for (const Complaint& complaint : model->complaints()) std::printf("%s\n", describe(complaint).c_str());
  return any_failure(model->complaints()) ? 1 : 0;
}

}  // namespace

int main(int count, char** words) {
  try {
    return run(parse(count, words));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "panel_trace: %s\n", error.what());
    return 2;
  }
}
