#pragma once
#include <cstdint>
#include <span>

namespace spanline::fuzz {

/// Reads a fuzzer's bytes one by one; beyond the end are zeros.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::uint8_t> bytes) : rest_(bytes) {}

  [[nodiscard]] bool empty() const { return rest_.empty(); }
  int byte() {
    if (rest_.empty()) return 0;
    const int value = rest_.front();
    rest_ = rest_.subspan(1);
    return value;
  }
  int signed_byte() { return static_cast<std::int8_t>(byte()); }
  /// 16 bits, signed, the low byte first.
  int half_word() {
    const int low = byte();
    return static_cast<std::int16_t>(low | byte() << 8);
  }
  /// 32 bits, signed, the low byte first.
  std::int32_t full_word() {
    const int low = half_word() & 0xffff;
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(half_word()) << 16 | static_cast<std::uint32_t>(low));
  }
  /// A number in [low, high].
  int between(int low, int high) { return low + (half_word() & 0xffff) % (high - low + 1); }
  bool chance(int one_in) { return byte() % one_in == 0; }

 private:
  std::span<const std::uint8_t> rest_;
};

}  // namespace spanline::fuzz
