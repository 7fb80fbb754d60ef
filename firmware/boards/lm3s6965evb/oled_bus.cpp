#include "oled_bus.hpp"

namespace {

using spanline::board::clear_bits;
using spanline::board::io;
using spanline::board::set_bits;
using spanline::board::touch;

// Synchronous serial interface 0 (Arm PrimeCell PL022; LM3S6965 data sheet of 2014, chapter 13).
constexpr std::uintptr_t ssi_control_0 = 0x40008000, ssi_control_1 = 0x40008004, ssi_data = 0x40008008,
                         ssi_status = 0x4000800c, ssi_prescale = 0x40008010, ssi_interrupt_mask = 0x40008014;
constexpr std::uint32_t status_transmit_not_full = 1U << 1, status_receive_not_empty = 1U << 2, status_busy = 1U << 4;
constexpr std::uint32_t mask_transmit_half_empty = 1U << 3;
constexpr std::uint32_t control_1_enable = 1U << 1;

/// Depth of both FIFOs, bytes.
constexpr int fifo_depth = 8;

// GPIO (PL061; data sheet, "General-Purpose Input/Outputs"): address bits 2 to 9 of the data register choose the pins
// that an access reaches.
constexpr std::uintptr_t gpio_a = 0x40004000, gpio_c = 0x40006000, gpio_d = 0x40007000;
constexpr std::uintptr_t gpio_direction = 0x400, gpio_alternate = 0x420, gpio_digital = 0x51c;
constexpr std::uint32_t pin_0 = 1U << 0, pin_7 = 1U << 7, pins_2_to_5 = 0x3c;

volatile std::uint32_t& gpio_data(std::uintptr_t port, std::uint32_t pins) { return io(port + (pins << 2)); }

/// Nested vectored interrupt controller: set-enable of interrupts 0 to 31; SSI0 is number 7.
constexpr std::uintptr_t interrupt_set_enable = 0xe000e100;
constexpr std::uint32_t interrupt_ssi0 = 1U << 7;

/// A byte takes 112 core clocks, so hardware that works takes one within a hundredth of this.
constexpr int polls = 10'000;

/// What the interrupt still has to send of the last pixels() call. The program writes it only while the interrupt is
/// masked.
const std::uint8_t* volatile next_byte = nullptr;
volatile std::uint32_t bytes_left = 0;

void start_clocks() {
  constexpr std::uintptr_t clock_gating_1 = 0x400fe104, clock_gating_2 = 0x400fe108;
  set_bits(io(clock_gating_1), 1U << 4);                      // SSI0
  set_bits(io(clock_gating_2), 1U << 0 | 1U << 2 | 1U << 3);  // GPIO A, C, D
  touch(clock_gating_2);                                      // three clocks must pass before a first access
}

void set_up_pins() {
  set_bits(io(gpio_a + gpio_alternate), pins_2_to_5);  // SSI0's clock, frame, receive and transmit
  set_bits(io(gpio_a + gpio_digital), pins_2_to_5);
  set_bits(io(gpio_c + gpio_direction), pin_7);
  set_bits(io(gpio_c + gpio_digital), pin_7);
  set_bits(io(gpio_d + gpio_direction), pin_0);
  set_bits(io(gpio_d + gpio_digital), pin_0);
  gpio_data(gpio_d, pin_0) = pin_0;
}

void set_data_mode(bool data) { gpio_data(gpio_c, pin_7) = data ? pin_7 : 0; }

/// What came in while bytes went out is nothing, but QEMU's PL022 stops sending while the receive FIFO is full.
void drain_receiver() {
  for (int i = 0; i < fifo_depth && (io(ssi_status) & status_receive_not_empty) != 0; ++i) {
    touch(ssi_data);
  }
}

bool wait_until(std::uint32_t bits, std::uint32_t wanted) {
  for (int poll = 0; poll < polls; ++poll) {
    if ((io(ssi_status) & bits) == wanted) return true;
  }
  return false;
}

/// Sends bytes and waits until the last has left, so that D/C may change.
bool send(std::span<const std::uint8_t> bytes) {
  for (const std::uint8_t byte : bytes) {
    if (!wait_until(status_transmit_not_full, status_transmit_not_full)) return false;
    io(ssi_data) = byte;
    drain_receiver();
  }
  const bool sent = wait_until(status_busy, 0);
  drain_receiver();
  return sent;
}

}  // namespace

/// SSI0 is the only chip interrupt enabled. Refills the transmit FIFO, at most one FIFO's worth an interrupt.
extern "C" void interrupt_handler() {
  drain_receiver();
  const std::uint8_t* byte = next_byte;
  std::uint32_t left = bytes_left;
  for (int i = 0; i < fifo_depth && left != 0 && (io(ssi_status) & status_transmit_not_full) != 0; ++i, --left) {
    io(ssi_data) = *byte++;
  }
  next_byte = byte;
  bytes_left = left;
  if (left == 0) io(ssi_interrupt_mask) = 0;
}

namespace spanline::board {

static_assert(hal::Bus<OledBus>);

OledBus::OledBus() {
  constexpr std::uint32_t eight_bits = 7;  // and SPI mode 0
  start_clocks();
  set_up_pins();
  io(ssi_control_1) = 0;
  io(ssi_prescale) = clock_divisor;
  io(ssi_control_0) = eight_bits;
  io(ssi_interrupt_mask) = 0;
  io(ssi_control_1) = control_1_enable;
  io(interrupt_set_enable) = interrupt_ssi0;
}

hal::DisplayStatus OledBus::command(std::span<const std::uint8_t> bytes) {
  if (bytes.empty()) return hal::DisplayStatus::ok;
  drain_receiver();
  set_data_mode(false);
  if (!send(bytes.first(1))) return hal::DisplayStatus::bus_timeout;
  if (bytes.size() == 1) return hal::DisplayStatus::ok;
  set_data_mode(true);
  return send(bytes.subspan(1)) ? hal::DisplayStatus::ok : hal::DisplayStatus::bus_timeout;
}

hal::DisplayStatus OledBus::pixels(std::span<const std::uint8_t> bytes) {
  if (bytes.empty()) return hal::DisplayStatus::ok;
  drain_receiver();
  set_data_mode(true);
  next_byte = bytes.data();
  bytes_left = static_cast<std::uint32_t>(bytes.size());
  io(ssi_interrupt_mask) = mask_transmit_half_empty;
  return hal::DisplayStatus::ok;
}

bool OledBus::busy() const { return bytes_left != 0 || (io(ssi_status) & status_busy) != 0; }

void OledBus::reset(bool held) {
  if (!held) return;
  io(ssi_interrupt_mask) = 0;
  bytes_left = 0;
  clear_bits(io(ssi_control_1), control_1_enable);
  set_bits(io(ssi_control_1), control_1_enable);
  drain_receiver();
}

}  // namespace spanline::board
