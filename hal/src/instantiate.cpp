// Instantiates drivers and present loop over a bus and a clock that do nothing, on every target: the compiler sees all
// of their code with the project's warnings, and the symbol check finds no heap, float or exception in it.
#include "spanline/hal/display_sink.hpp"
#include "spanline/hal/panels/ili9341.hpp"
#include "spanline/hal/panels/ssd0323.hpp"
#include "spanline/hal/panels/st7789.hpp"
#include "spanline/hal/present.hpp"

namespace spanline::hal::check {

struct NullBus {
  DisplayStatus command(std::span<const std::uint8_t>) { return DisplayStatus::ok; }
  DisplayStatus pixels(std::span<const std::uint8_t>) { return DisplayStatus::ok; }
  bool busy() { return false; }
  void reset(bool) {}
  std::uint32_t clock_hz() { return 1'000'000; }
};

struct NullClock {
  std::uint32_t now_us() { return 0; }
  void delay_us(std::uint32_t) {}
};

struct NullCounter {
  std::uint32_t cycles() { return 0; }
};

/// A bus with a line back and a backlight, which init() and switch_on() use.
struct NullReadableBus : NullBus {
  void backlight(bool) {}
  DisplayStatus read(std::uint8_t, std::span<std::uint8_t>) { return DisplayStatus::ok; }
};

struct NullFiller {
  void fill(std::uint16_t, std::uint32_t, std::uint16_t*) {}
  bool filled() { return true; }
};

using Portrait = Ili9341<NullReadableBus, NullClock, MipiOptions{.orientation = Orientation::portrait}>;
using Landscape = Ili9341<NullBus, NullClock>;
using Small = St7789<st7789::glass_135x240, NullBus, NullClock, MipiOptions{.colours = ColourFormat::rgb444}>;
using Oled = Ssd0323<NullBus, NullClock>;
static_assert(Panel<Portrait> && Panel<Landscape> && Panel<Small> && Panel<Oled> && CycleCounter<NullCounter>);

}  // namespace spanline::hal::check

namespace spanline::hal {

template class MipiPanel<Ili9341Chip, check::NullReadableBus, check::NullClock,
                         MipiOptions{.orientation = Orientation::portrait}>;
template class MipiPanel<Ili9341Chip, check::NullBus, check::NullClock>;
template class MipiPanel<St7789Chip<st7789::glass_135x240>, check::NullBus, check::NullClock,
                         MipiOptions{.colours = ColourFormat::rgb444}>;
template class Ssd0323<check::NullBus, check::NullClock>;
template class Present<check::Landscape, check::NullClock>;
template class Present<check::Oled, check::NullClock>;
template class DisplaySink<check::Landscape, check::NullClock>;
template class DisplaySink<check::Landscape, check::NullClock, check::NullFiller>;

}  // namespace spanline::hal
