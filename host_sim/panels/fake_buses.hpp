#pragma once
#include <algorithm>
#include <cstdint>
#include <span>

#include "panels/host_bus.hpp"
#include "panels/sim_clock.hpp"
#include "spanline/hal/bus.hpp"

namespace spanline::sim {

/// A bus that finishes each transfer of pixels only `transfer_us` after its start, whatever its size. A test that draws
/// says so by draw(), and learns how often drawing overlapped a transfer.
class LateBus {
 public:
  LateBus(SimClock& clock, std::uint32_t transfer_us) : clock_(clock), transfer_us_(transfer_us) {}

  hal::DisplayStatus command(std::span<const std::uint8_t>) {
    if (busy()) ++misuses_;
    return hal::DisplayStatus::ok;
  }
  hal::DisplayStatus pixels(std::span<const std::uint8_t>) {
    if (busy()) ++misuses_;
    ++transfers_;
    done_ns_ = clock_.now_ns() + std::uint64_t{transfer_us_} * 1000;
    return hal::DisplayStatus::ok;
  }
  [[nodiscard]] bool busy() const { return clock_.now_ns() < done_ns_; }
  void reset(bool held) {
    if (held) done_ns_ = 0;
  }
  [[nodiscard]] std::uint32_t clock_hz() const { return 1'000'000; }

  /// Drawing that takes `us` begins now.
  void draw(std::uint32_t us) {
    if (busy()) ++draws_while_busy_;
    clock_.delay_us(us);
  }

  [[nodiscard]] int draws_while_busy() const { return draws_while_busy_; }
  [[nodiscard]] int transfers() const { return transfers_; }
  [[nodiscard]] int misuses() const { return misuses_; }  ///< commands or pixels while busy

 private:
  SimClock& clock_;
  std::uint32_t transfer_us_;
  std::uint64_t done_ns_ = 0;
  int draws_while_busy_ = 0;
  int transfers_ = 0;
  int misuses_ = 0;
};

/// A bus that works until it is told to stick, and then never finishes anything until it is told to recover: transfers
/// stay in flight, commands time out, and a reset does not help.
class StuckBus {
 public:
  explicit StuckBus(HostBus& inner) : inner_(inner) {}

  /// The transfer number `transfer` from now, counted from 1, never finishes; with 0 the bus is stuck at once.
  void stick_at(int transfer) {
    remaining_ = transfer;
    stuck_ = transfer == 0;
  }
  void recover() { stuck_ = false; }

  hal::DisplayStatus command(std::span<const std::uint8_t> bytes) {
    return stuck_ ? hal::DisplayStatus::bus_timeout : inner_.command(bytes);
  }
  hal::DisplayStatus read(std::uint8_t command, std::span<std::uint8_t> answer) {
    return stuck_ ? hal::DisplayStatus::bus_timeout : inner_.read(command, answer);
  }
  hal::DisplayStatus pixels(std::span<const std::uint8_t> bytes) {
    if (remaining_ > 0 && --remaining_ == 0) stuck_ = true;
    return stuck_ ? hal::DisplayStatus::ok : inner_.pixels(bytes);
  }
  bool busy() { return stuck_ || inner_.busy(); }
  void reset(bool held) { inner_.reset(held); }
  void backlight(bool lit) { inner_.backlight(lit); }
  [[nodiscard]] std::uint32_t clock_hz() const { return inner_.clock_hz(); }

 private:
  HostBus& inner_;
  int remaining_ = 0;
  bool stuck_ = false;
};

/// A bus on which one transfer of pixels breaks off: its first bytes arrive, and pixels() returns `failure`.
class FailingBus {
 public:
  FailingBus(HostBus& inner, SimClock& clock, hal::DisplayStatus failure)
      : inner_(inner), clock_(clock), failure_(failure) {}

  /// The transfer number `transfer` from now, counted from 1, ends after `bytes` bytes.
  void fail_at(int transfer, std::size_t bytes) {
    remaining_ = transfer;
    bytes_ = bytes;
  }

  hal::DisplayStatus command(std::span<const std::uint8_t> bytes) { return inner_.command(bytes); }
  hal::DisplayStatus pixels(std::span<const std::uint8_t> bytes) {
    if (remaining_ == 0 || --remaining_ != 0) return inner_.pixels(bytes);
    static_cast<void>(inner_.pixels(bytes.first(bytes_)));
    while (inner_.busy()) clock_.delay_us(100);
    return failure_;
  }
  bool busy() { return inner_.busy(); }
  void reset(bool held) { inner_.reset(held); }
  void backlight(bool lit) { inner_.backlight(lit); }
  [[nodiscard]] std::uint32_t clock_hz() const { return inner_.clock_hz(); }

 private:
  HostBus& inner_;
  SimClock& clock_;
  hal::DisplayStatus failure_;
  int remaining_ = 0;
  std::size_t bytes_ = 0;
};

/// A bus that queues up to `size` transfers, each of which takes `transfer_us`, one after the other.
class QueueBus {
 public:
  static constexpr std::uint32_t size = 4;

  QueueBus(SimClock& clock, std::uint32_t transfer_us) : clock_(clock), transfer_us_(transfer_us) {}

  hal::DisplayStatus command(std::span<const std::uint8_t>) {
    if (busy()) ++misuses_;
    ++commands_;
    return hal::DisplayStatus::ok;
  }
  hal::DisplayStatus pixels(std::span<const std::uint8_t>) {
    if (!takes_pixels()) return hal::DisplayStatus::bus_busy;
    ++transfers_;
    done_ns_ = std::max(done_ns_, clock_.now_ns()) + transfer_ns();
    return hal::DisplayStatus::ok;
  }
  [[nodiscard]] bool busy() const { return clock_.now_ns() < done_ns_; }
  [[nodiscard]] bool takes_pixels() const { return transfers_left() < size; }
  [[nodiscard]] std::uint32_t transfers_left() const {
    if (!busy()) return 0;
    return static_cast<std::uint32_t>((done_ns_ - clock_.now_ns() + transfer_ns() - 1) / transfer_ns());
  }
  void reset(bool held) {
    if (held) done_ns_ = 0;
  }
  [[nodiscard]] std::uint32_t clock_hz() const { return 1'000'000; }

  [[nodiscard]] int commands() const { return commands_; }
  [[nodiscard]] int transfers() const { return transfers_; }
  [[nodiscard]] int misuses() const { return misuses_; }  ///< commands while busy

 private:
  [[nodiscard]] std::uint64_t transfer_ns() const { return std::uint64_t{transfer_us_} * 1000; }

  SimClock& clock_;
  std::uint32_t transfer_us_;
  std::uint64_t done_ns_ = 0;
  int commands_ = 0;
  int transfers_ = 0;
  int misuses_ = 0;
};

/// A bus whose plug can be pulled: bytes go nowhere, and nothing comes back but the level of a line that a resistor
/// holds high.
class PluggedBus {
 public:
  explicit PluggedBus(HostBus& inner) : inner_(inner) {}

  void plug(bool in) { plugged_ = in; }

  hal::DisplayStatus command(std::span<const std::uint8_t> bytes) {
    return plugged_ ? inner_.command(bytes) : hal::DisplayStatus::ok;
  }
  hal::DisplayStatus read(std::uint8_t command, std::span<std::uint8_t> answer) {
    if (plugged_) return inner_.read(command, answer);
    std::fill(answer.begin(), answer.end(), std::uint8_t{0xFF});
    return hal::DisplayStatus::ok;
  }
  hal::DisplayStatus pixels(std::span<const std::uint8_t> bytes) {
    return plugged_ ? inner_.pixels(bytes) : hal::DisplayStatus::ok;
  }
  bool busy() { return plugged_ && inner_.busy(); }
  void reset(bool held) {
    if (plugged_) inner_.reset(held);
  }
  void backlight(bool lit) { inner_.backlight(lit); }
  [[nodiscard]] std::uint32_t clock_hz() const { return inner_.clock_hz(); }

 private:
  HostBus& inner_;
  bool plugged_ = true;
};

}  // namespace spanline::sim
