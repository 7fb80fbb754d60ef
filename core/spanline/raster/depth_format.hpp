#pragma once
#include <cstdint>

namespace spanline {

/// Which depth is nearer to the eye (the lectures use both: 001 and 002 smaller, 000 and 003 larger).
enum class DepthSense : std::uint8_t { smaller_is_nearer, larger_is_nearer };

/// A depth format: what the depth buffer stores of a 32-bit plane word.
///
/// Vertices always carry smaller-is-nearer integers of `bits` bits. A plane word has these bits on top and `guard_bits`
/// below; ½ is added at set-up, so that dropping the guard bits rounds. The other sense complements the whole word,
/// which is linear too (~z = −z − 1), so both senses order the same pixels in the same way and draw the same picture.
template <int Bits, class StoredWord, DepthSense DepthOrder>
struct DepthFormat {
  using Word = StoredWord;
  static constexpr int bits = Bits;
  static constexpr int guard_bits = 32 - Bits;
  static constexpr DepthSense sense = DepthOrder;
  static constexpr bool smaller = sense == DepthSense::smaller_is_nearer;
  static constexpr int stored_shift = 32 - static_cast<int>(sizeof(Word)) * 8;  ///< plane word → stored word

  /// Vertex depths keep away from the ends of the range, so that rounding of a plane never wraps from near to far, and
  /// the clear value lies outside. At 24 bits a plane may be off by a few units at the largest pictures.
  static constexpr std::uint32_t nearest = Bits == 16 ? 0 : 16;
  static constexpr std::uint32_t farthest = Bits == 16 ? 65534 : (1u << 24) - 17;

  /// The stored word that every polygon beats.
  static constexpr Word clear = smaller ? static_cast<Word>(~Word{0}) : Word{0};

  /// What the buffer keeps of a plane word.
  static constexpr std::uint32_t stored(std::uint32_t plane_word) { return plane_word >> stored_shift; }

  /// Whether a new depth hides a stored one; equal depths keep the polygon that was submitted first.
  static constexpr bool hides(std::uint32_t candidate, Word kept) {
    return smaller ? candidate < kept : candidate > kept;
  }

  /// The depth integer of a stored word, as --depth-out shows it: guard bits dropped.
  static constexpr std::uint32_t integer(Word kept) {
    return sizeof(Word) == 4 ? static_cast<std::uint32_t>(kept) >> guard_bits : kept;
  }
};

/// 16 bits stored, 16 guard bits in the plane word alone.
template <DepthSense Sense = DepthSense::smaller_is_nearer>
using Depth16 = DepthFormat<16, std::uint16_t, Sense>;

/// 24 bits and 8 guard bits, all stored: comparisons see the full word, so that every exact algorithm agrees.
template <DepthSense Sense = DepthSense::smaller_is_nearer>
using Depth24 = DepthFormat<24, std::uint32_t, Sense>;

}  // namespace spanline
