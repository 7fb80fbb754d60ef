#include "panels/panel_registry.hpp"

#include <algorithm>
#include <cstddef>

#include "panels/host_bus.hpp"
#include "panels/ili9341_model.hpp"
#include "panels/sim_clock.hpp"
#include "panels/ssd0323_model.hpp"
#include "spanline/hal/panels/ili9341.hpp"
#include "spanline/hal/panels/ssd0323.hpp"

namespace spanline::sim {
namespace {

template <hal::Orientation orientation>
struct Ili9341Parts {
  using Driver = hal::Ili9341<HostBus, SimClock, orientation>;
  static Ili9341Model make_model() { return Ili9341Model(orientation); }
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

  hal::Status show(int band_height, const DrawBand& draw) override {
    const int rows = std::clamp(band_height, 1, Driver::height);
    hal::Status status = present_.begin_frame();
    for (int y0 = 0, index = 0; status == hal::Status::ok && y0 < Driver::height; y0 += rows, index ^= 1) {
      const int y1 = std::min(y0 + rows, Driver::height);
      status = present_.acquire(index);
      if (status != hal::Status::ok) break;
      const auto band = present_.buffer(index).first(static_cast<std::size_t>(y1 - y0) * Driver::width);
      draw(y0, y1, band);
      if (drawn_order_ != Driver::pixel_order) turn_round(band);
      status = present_.submit(y0, y1, index);
    }
    const hal::Status ended = present_.end_frame();
    if (ended == hal::Status::ok) model_.end_of_stream();
    return status == hal::Status::ok ? ended : status;
  }

  hal::Status sleep(bool asleep) override { return driver_.sleep(asleep); }
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

using Factory = std::unique_ptr<PanelSession> (*)(const PanelInfo&, const PanelOptions&);

template <typename Parts>
std::unique_ptr<PanelSession> make_session(const PanelInfo& info, const PanelOptions& options) {
  return std::make_unique<Session<Parts>>(info, options);
}

template <typename Parts>
constexpr PanelInfo describe_panel(std::string_view name, std::string_view panel_class, std::string_view description) {
  using Driver = typename Parts::Driver;
  return {name, panel_class, description, Driver::width, Driver::height, Driver::pixel_order, Driver::clock_rating};
}

using Landscape = Ili9341Parts<hal::Orientation::landscape>;
using Portrait = Ili9341Parts<hal::Orientation::portrait>;

// A panel is one line in each of these two tables.
constexpr PanelInfo infos[] = {
    describe_panel<Landscape>("ili9341", "320x240 rgb565", "ILI9341 colour TFT, held in landscape"),
    describe_panel<Portrait>("ili9341-portrait", "240x320 rgb565", "ILI9341 colour TFT, held in portrait"),
    describe_panel<Ssd0323Parts>("ssd0323", "128x64 grey4", "SSD0323 OLED with 16 grey levels"),
};
constexpr Factory factories[] = {make_session<Landscape>, make_session<Portrait>, make_session<Ssd0323Parts>};
static_assert(std::size(infos) == std::size(factories));

}  // namespace

std::span<const PanelInfo> panels() { return infos; }

const PanelInfo* find_panel(std::string_view name) {
  const auto* found =
      std::find_if(std::begin(infos), std::end(infos), [name](const PanelInfo& info) { return info.name == name; });
  return found == std::end(infos) ? nullptr : found;
}

std::unique_ptr<PanelSession> open_panel(std::string_view name, const PanelOptions& options) {
  const PanelInfo* info = find_panel(name);
  return info == nullptr ? nullptr : factories[info - infos](*info, options);
}

}  // namespace spanline::sim
