#pragma once
#include <cstddef>
#include <cstdint>

namespace spanline::scenes {

/// The CRC of IEEE 802.3 and of zip files (reflected polynomial 0xEDB88320) over words of a picture, low byte first, so
/// that machines of any word size and the host compute the same.
class Crc32 {
 public:
  template <class Word>
  constexpr void add(Word word) {
    for (std::size_t byte = 0; byte < sizeof(Word); ++byte) {
      state_ ^= static_cast<std::uint32_t>((word >> (8 * byte)) & 0xff);
      for (int bit = 0; bit < 8; ++bit) state_ = (state_ >> 1) ^ (0xEDB88320u & (0u - (state_ & 1)));
    }
  }
  [[nodiscard]] constexpr std::uint32_t value() const { return ~state_; }

 private:
  std::uint32_t state_ = ~0u;
};

}  // namespace spanline::scenes
