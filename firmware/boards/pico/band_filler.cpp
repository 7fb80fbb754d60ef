#include "band_filler.hpp"

#include "registers.hpp"

namespace {

using namespace spanline::board;

constexpr std::uintptr_t first_channel = 0x50000040, channel_stride = 0x40, read_address = 0x00, write_address = 0x04,
                         count_of_transfers = 0x08, control_and_start = 0x0c;
constexpr std::uintptr_t abort_channels = 0x50000444;
constexpr std::uint32_t both_channels = 1U << 1 | 1U << 2;
constexpr std::uint32_t enable = 1U << 0, words_of_32_bits = 2U << 2, rising_write = 1U << 5, unpaced = 0x3fU << 15,
                        no_interrupt = 1U << 21, is_busy = 1U << 24;

constexpr std::uintptr_t channel(unsigned number) { return first_channel + number * channel_stride; }

/// A band of 320 × 48 pixels takes 7,680 cycles, and a turn of the loop about ten.
constexpr int polls = 100'000;

bool wait_for(unsigned number) {
  for (int poll = 0; poll < polls; ++poll) {
    if ((io(channel(number) + control_and_start) & is_busy) == 0) return true;
  }
  return false;
}

}  // namespace

namespace spanline::board {

void BandFiller::fill(std::uint16_t value, std::uint32_t count, std::uint16_t* words) {
  const unsigned number = next_;
  next_ ^= 1;
  if (!wait_for(number)) return;  // filled() says so
  if ((count & 1) != 0) words[count - 1] = value;
  values_[number] = value * 0x10001U;
  const std::uintptr_t at = channel(number);
  io(at + read_address) = static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(&values_[number]));
  io(at + write_address) = static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(words));
  io(at + count_of_transfers) = count / 2;
  const std::uint32_t chained_to_itself = (number + 1) << 11;
  asm volatile("" ::: "memory");  // the value is in memory when the channel reads it
  io(at + control_and_start) = enable | words_of_32_bits | rising_write | unpaced | no_interrupt | chained_to_itself;
}

bool BandFiller::filled() {
  const bool ended = wait_for(0) && wait_for(1);
  if (!ended) io(abort_channels) = both_channels;  // the next frame tries again
  asm volatile("" ::: "memory");
  return ended;
}

}  // namespace spanline::board
