#include "panels/panel_registry.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>

#include "panels/host_bus.hpp"
#include "panels/ili9341_model.hpp"
#include "panels/sim_clock.hpp"
#include "panels/ssd0323_model.hpp"
#include "panels/st7789_model.hpp"
#include "spanline/hal/panels/ili9341.hpp"
#include "spanline/hal/panels/ssd0323.hpp"
#include "spanline/hal/panels/st7789.hpp"

namespace spanline::sim {
namespace {

using hal::MipiOptions;
using hal::Orientation;

template <Orientation orientation>
struct Ili9341Parts {
  using Driver = hal::Ili9341<HostBus, SimClock, MipiOptions{.orientation = orientation}>;
  static Ili9341Model make_model() { return Ili9341Model(orientation); }
};

template <hal::mipi::Glass glass, St7789Glass model, MipiOptions options>
struct St7789Parts {
  using Driver = hal::St7789<glass, HostBus, SimClock, options>;
  static St7789Model make_model() { return {model, options.orientation}; }
};

struct Ssd0323Parts {
  using Driver = hal::Ssd0323<HostBus, SimClock>;
  static Ssd0323Model make_model() { return {}; }
};

template <typename Parts>
class Session : public PanelSession {
 public:
  using Driver = typename Parts::Driver;

  Session(const PanelInfo& info, const PanelOptions& options)
      : info_(info),
        drawn_order_(options.drawn_order),
        bus_(model_, clock_, options.clock_hz == 0 ? info.clock_rating.rated_hz : options.clock_hz) {}

  [[nodiscard]] const PanelInfo& info() const override { return info_; }

  hal::DisplayStatus show(int band_height, const DrawBand& draw) override {
    const int rows = std::clamp(band_height, 1, Driver::height);
    hal::DisplayStatus status = present_.begin_frame();
    for (int y0 = 0, index = 0; status == hal::DisplayStatus::ok && y0 < Driver::height; y0 += rows, index ^= 1) {
      const int y1 = std::min(y0 + rows, Driver::height);
      status = present_.acquire(index);
      if (status != hal::DisplayStatus::ok) break;
      const auto band = present_.buffer(index).first(static_cast<std::size_t>(y1 - y0) * Driver::width);
      draw(y0, y1, band);
      if (drawn_order_ != Driver::pixel_order) turn_round(band);
      status = present_.submit(y0, y1, index);
    }
    const hal::DisplayStatus ended = present_.end_frame();
    if (ended == hal::DisplayStatus::ok) model_.end_of_stream();
    return status == hal::DisplayStatus::ok ? ended : status;
  }

  hal::DisplayStatus sleep(bool asleep) override { return driver_.sleep(asleep); }
  [[nodiscard]] PanelPicture picture() const override { return model_.picture(); }
  [[nodiscard]] const std::vector<Complaint>& complaints() const override { return model_.complaints(); }
  [[nodiscard]] const hal::PresentStatistics& statistics() const override { return present_.statistics(); }

 private:
  static constexpr std::size_t frame_words = static_cast<std::size_t>(Driver::width) * Driver::height;

  static void turn_round(std::span<std::uint16_t> words) {
    for (std::uint16_t& word : words) word = hal::to_pixel_order(hal::PixelOrder::high_byte_first, word);
  }

  const PanelInfo& info_;
  hal::PixelOrder drawn_order_;
  SimClock clock_;
  decltype(Parts::make_model()) model_ = Parts::make_model();
  HostBus bus_;
  Driver driver_{bus_, clock_};
  std::vector<std::uint16_t> first_ = std::vector<std::uint16_t>(frame_words);
  std::vector<std::uint16_t> second_ = std::vector<std::uint16_t>(frame_words);
  // Simulated buses always finish; the timeout only has to be longer than a whole frame at the slowest clock in use.
  hal::Present<Driver, SimClock> present_{driver_, clock_, first_, second_, 60'000'000};
};

template <typename Parts>
std::unique_ptr<PanelSession> new_session(const PanelInfo& info, const PanelOptions& options) {
  return std::make_unique<Session<Parts>>(info, options);
}

template <typename Parts>
std::unique_ptr<PanelModel> new_model() {
  return std::make_unique<decltype(Parts::make_model())>(Parts::make_model());
}

template <typename Parts>
constexpr PanelInfo describe_panel(std::string_view name, std::string_view panel_class, std::string_view description) {
  using Driver = typename Parts::Driver;
  return {name, panel_class, description, Driver::width, Driver::height, Driver::pixel_order, Driver::clock_rating};
}

using Landscape = Ili9341Parts<Orientation::landscape>;
using Portrait = Ili9341Parts<Orientation::portrait>;

template <MipiOptions options>
using St7789 = St7789Parts<hal::st7789::glass_240x320, St7789Glass::size_240x320, options>;
template <MipiOptions options>
using SquareSt7789 = St7789Parts<hal::st7789::glass_240x240, St7789Glass::size_240x240, options>;
template <MipiOptions options>
using NarrowSt7789 = St7789Parts<hal::st7789::glass_135x240, St7789Glass::size_135x240, options>;

constexpr MipiOptions landscape{.orientation = Orientation::landscape};
constexpr MipiOptions portrait{.orientation = Orientation::portrait};
constexpr MipiOptions landscape_444{.orientation = Orientation::landscape, .colours = hal::ColourFormat::rgb444};

// A panel is one line in this table.
struct Entry {
  PanelInfo info;
  std::unique_ptr<PanelSession> (*make_session)(const PanelInfo&, const PanelOptions&);
  std::unique_ptr<PanelModel> (*make_model)();
};

template <typename Parts>
constexpr Entry entry(std::string_view name, std::string_view panel_class, std::string_view description) {
  return {describe_panel<Parts>(name, panel_class, description), new_session<Parts>, new_model<Parts>};
}

constexpr Entry entries[] = {
    entry<Landscape>("ili9341", "320x240 rgb565", "ILI9341 colour TFT, held in landscape"),
    entry<Portrait>("ili9341-portrait", "240x320 rgb565", "ILI9341 colour TFT, held in portrait"),
    entry<St7789<landscape>>("st7789", "320x240 rgb565", "ST7789 colour TFT, held in landscape"),
    entry<St7789<portrait>>("st7789-portrait", "240x320 rgb565", "ST7789 colour TFT, held in portrait"),
    entry<St7789<landscape_444>>("st7789-444", "320x240 rgb444", "ST7789 in landscape with 12 bits a pixel"),
    entry<SquareSt7789<landscape>>("st7789-240x240", "240x240 rgb565", "ST7789 with the square glass"),
    entry<NarrowSt7789<landscape>>("st7789-135x240", "240x135 rgb565", "ST7789 with the narrow glass, in landscape"),
    entry<Ssd0323Parts>("ssd0323", "128x64 grey4", "SSD0323 OLED with 16 grey levels"),
};

constexpr auto infos = [] {
  std::array<PanelInfo, std::size(entries)> list{};
  std::transform(std::begin(entries), std::end(entries), list.begin(), [](const Entry& e) { return e.info; });
  return list;
}();

const Entry* find_entry(std::string_view name) {
  const auto* found =
      std::find_if(std::begin(entries), std::end(entries), [name](const Entry& e) { return e.info.name == name; });
  return found == std::end(entries) ? nullptr : found;
}

}  // namespace

std::span<const PanelInfo> panels() { return infos; }

const PanelInfo* find_panel(std::string_view name) {
  const Entry* entry = find_entry(name);
  return entry == nullptr ? nullptr : &infos[static_cast<std::size_t>(entry - entries)];
}

std::unique_ptr<PanelSession> open_panel(std::string_view name, const PanelOptions& options) {
  const Entry* entry = find_entry(name);
  return entry == nullptr ? nullptr : entry->make_session(entry->info, options);
}

std::unique_ptr<PanelModel> make_panel_model(std::string_view name) {
  const Entry* entry = find_entry(name);
  return entry == nullptr ? nullptr : entry->make_model();
}

}  // namespace spanline::sim
