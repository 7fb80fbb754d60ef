#include "spi_bus.hpp"

#include <algorithm>
#include <array>

#include "interrupts.hpp"
#include "registers.hpp"

namespace {

using namespace spanline::board;
namespace pin = display_pins;

// SPI0 (Arm PrimeCell PL022; RP2040 data sheet, section 4.4).
constexpr std::uintptr_t spi_control_0 = 0x4003c000, spi_control_1 = 0x4003c004, spi_data = 0x4003c008,
                         spi_status = 0x4003c00c, spi_prescale = 0x4003c010, spi_clear = 0x4003c020,
                         spi_dma = 0x4003c024;
constexpr std::uint32_t status_transmit_not_full = 1U << 1, status_receive_not_empty = 1U << 2, status_busy = 1U << 4;
constexpr std::uint32_t control_1_enable = 1U << 1, dma_transmit = 1U << 1, clear_overrun = 1U << 0;
constexpr std::uint32_t eight_bits_mode_3 = 7U | 1U << 6 | 1U << 7;

// DMA channel 0 (section 2.5.7).
constexpr std::uintptr_t dma_read = 0x50000000, dma_write = 0x50000004, dma_control = 0x50000010,
                         dma_count_and_start = 0x5000001c, dma_interrupts = 0x50000400, dma_enable_0 = 0x50000404,
                         dma_abort = 0x50000444;
constexpr std::uint32_t channel_0 = 1U << 0;
constexpr std::uint32_t request_spi0_transmit = 16;
/// Bytes from rising addresses to one register, whenever SPI0 has room, chained to nothing.
constexpr std::uint32_t dma_bytes_to_spi = 1U << 0 | 1U << 4 | request_spi0_transmit << 15;

/// A byte takes 16 cycles at 62.5 MHz and 4,064 at the slowest, and a turn of a polling loop about ten.
constexpr int polls = 10'000;

constexpr std::uint32_t bit(unsigned number) { return 1U << number; }

/// Bands on their way, the first of them under transfer. Written with the interrupt masked.
struct Queue {
  static constexpr std::uint32_t size = 16;  // a power of two
  struct Band {
    const std::uint8_t* first;
    std::uint32_t bytes;
  };
  std::array<Band, size> bands;
  volatile std::uint32_t started, added;  ///< counts modulo 2^32
};
constinit Queue queue{};

/// Interrupts masked while it lives.
class Masked {
 public:
  Masked() { asm volatile("cpsid i" ::: "memory"); }
  ~Masked() { asm volatile("cpsie i" ::: "memory"); }
  Masked(const Masked&) = delete;
  Masked& operator=(const Masked&) = delete;
};

[[gnu::always_inline]] inline void start_transfer(const Queue::Band& band) {
  io(dma_read) = static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(band.first));
  io(dma_count_and_start) = band.bytes;
}

void set_level(unsigned number, bool high) { io(high ? sio::out_set : sio::out_clear) = bit(number); }

void drain_receiver() {
  while ((io(spi_status) & status_receive_not_empty) != 0) touch(spi_data);
  io(spi_clear) = clear_overrun;
}

bool wait_until(std::uint32_t bits, std::uint32_t wanted) {
  for (int poll = 0; poll < polls; ++poll) {
    if ((io(spi_status) & bits) == wanted) return true;
  }
  return false;
}

/// Sends bytes and waits until the last has left, so that D/C may change.
bool send(std::span<const std::uint8_t> bytes) {
  for (const std::uint8_t byte : bytes) {
    if (!wait_until(status_transmit_not_full, status_transmit_not_full)) return false;
    io(spi_data) = byte;
  }
  return wait_until(status_busy, 0);
}

/// The serial clock is the peripheral clock over an even prescaler, 2 to 254, and a divider, 1 to 256. Only the first
/// is used: it goes down to 492 kHz.
struct Divider {
  std::uint32_t prescaler, clock_hz;
  static constexpr Divider at_most(std::uint32_t hz) {
    std::uint32_t prescaler = 2;
    while (prescaler < 254 && system_clock_hz / prescaler > hz) prescaler += 2;
    return {prescaler, system_clock_hz / prescaler};
  }
};
static_assert(Divider::at_most(62'500'000).clock_hz == 62'500'000);
static_assert(Divider::at_most(62'499'999).clock_hz == 31'250'000);

/// The prescaler is changed only while the port is off (RP2040 data sheet, 4.4.3, "Configuring the SSP").
void set_clock(Divider divider) {
  io(spi_control_1) = 0;
  io(spi_prescale) = divider.prescaler;
  io(spi_control_1) = control_1_enable;
}

void set_up_pins() {
  constexpr std::uint32_t outputs =
      bit(pin::chip_select) | bit(pin::data_command) | bit(pin::reset) | bit(pin::backlight);
  io(sio::out_set) = bit(pin::chip_select) | bit(pin::reset);
  io(sio::out_clear) = bit(pin::backlight);
  io(sio::direction_set) = outputs;
  for (const unsigned number : {pin::chip_select, pin::data_command, pin::reset, pin::backlight})
    pins::select(number, pins::sio);
  for (const unsigned number : {pin::clock, pin::mosi}) {
    pins::drive_fast(number);
    pins::select(number, pins::spi);
  }
}

void set_up_dma() {
  io(dma_write) = spi_data;
  io(dma_control) = dma_bytes_to_spi;
  io(dma_enable_0) = channel_0;
  io(nvic::set_enable) = nvic::dma_0;
}

}  // namespace

namespace spanline::board {

static_assert(hal::QueueingBus<SpiBus> && hal::BacklitBus<SpiBus> && hal::ReadableBus<ReadableSpiBus>);

/// In RAM, so that the next band starts while the FIFO still has bytes of the last.
[[gnu::section(".time_critical.band_sent")]] void band_sent() {
  io(dma_interrupts) = channel_0;
  const std::uint32_t next = queue.started + 1;
  queue.started = next;
  if (next != queue.added) start_transfer(queue.bands[next % Queue::size]);
}

SpiBus::SpiBus(std::uint32_t asked_hz) : asked_hz_(asked_hz), clock_hz_(Divider::at_most(asked_hz).clock_hz) {
  set_up();
}

void SpiBus::set_up() const {
  resets::restart(resets::spi0 | resets::dma);
  set_up_pins();
  io(spi_control_0) = eight_bits_mode_3;
  io(spi_dma) = dma_transmit;
  set_clock(Divider::at_most(asked_hz_));
  queue.started = 0;
  queue.added = 0;
  set_up_dma();
}

hal::DisplayStatus SpiBus::command(std::span<const std::uint8_t> bytes) {
  if (bytes.empty()) return hal::DisplayStatus::ok;
  // Selecting it anew has the display count bits from here, whatever it missed before.
  set_level(pin::chip_select, true);
  asm volatile("nop\n nop\n nop\n nop");
  set_level(pin::chip_select, false);
  set_level(pin::data_command, false);
  if (!send(bytes.first(1))) return hal::DisplayStatus::bus_timeout;
  set_level(pin::data_command, true);
  const bool sent = send(bytes.subspan(1));
  drain_receiver();
  return sent ? hal::DisplayStatus::ok : hal::DisplayStatus::bus_timeout;
}

[[gnu::section(".time_critical.pixels")]] hal::DisplayStatus SpiBus::pixels(std::span<const std::uint8_t> bytes) {
  if (bytes.empty()) return hal::DisplayStatus::ok;
  io(sio::out_clear) = bit(pin::chip_select);
  io(sio::out_set) = bit(pin::data_command);
  const Masked masked;
  const std::uint32_t added = queue.added;
  if (added - queue.started == Queue::size) return hal::DisplayStatus::bus_busy;
  Queue::Band& band = queue.bands[added % Queue::size];
  band = {bytes.data(), static_cast<std::uint32_t>(bytes.size())};
  queue.added = added + 1;
  if (queue.started == added) start_transfer(band);
  return hal::DisplayStatus::ok;
}

bool SpiBus::busy() const { return transfers_left() != 0 || (io(spi_status) & status_busy) != 0; }

bool SpiBus::takes_pixels() const { return transfers_left() < Queue::size; }

std::uint32_t SpiBus::transfers_left() const { return queue.added - queue.started; }

void SpiBus::reset(bool held) {
  if (held) {
    // The channel's interrupt must be off while it is abandoned, or it may still come (RP2040-E13).
    io(dma_enable_0) = 0;
    io(dma_abort) = channel_0;
    io(nvic::clear_pending) = nvic::dma_0;
    set_up();
  }
  set_level(pin::reset, !held);
}

void SpiBus::backlight(bool lit) { set_level(pin::backlight, lit); }

hal::DisplayStatus SpiBus::read_bytes(std::uint8_t command, std::span<std::uint8_t> answer) {
  constexpr std::uint32_t read_hz = 5'000'000;
  if (!wait_until(status_busy, 0)) return hal::DisplayStatus::bus_timeout;
  drain_receiver();
  set_level(pin::chip_select, true);  // the serial clock may move while the port is off
  set_clock(Divider::at_most(read_hz));
  set_level(pin::chip_select, false);
  set_level(pin::data_command, false);
  bool good = send(std::span(&command, 1));
  drain_receiver();
  set_level(pin::data_command, true);
  for (std::uint8_t& byte : answer) {
    constexpr std::uint8_t nothing = 0;
    good = good && send(std::span(&nothing, 1));
    byte = static_cast<std::uint8_t>(io(spi_data));
  }
  set_level(pin::chip_select, true);
  set_clock(Divider::at_most(asked_hz_));
  return good ? hal::DisplayStatus::ok : hal::DisplayStatus::bus_timeout;
}

ReadableSpiBus::ReadableSpiBus(std::uint32_t asked_hz) : SpiBus(asked_hz) {
  pins::pull_up(pin::miso);
  pins::select(pin::miso, pins::spi);
}

}  // namespace spanline::board
