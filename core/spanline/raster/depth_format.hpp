#pragma once
#include <cstdint>

namespace spanline {

/// Which depth is nearer to the eye. Lectures 001 and 002 use the smaller, lectures 000 and 003 the larger.
enum class DepthSense : std::uint8_t { smaller_is_nearer, larger_is_nearer };

/// A depth format: how a 32-bit plane word is made from depths and which of its bits the depth buffer stores.
///
/// Depths of vertices are integers of `bits` bits where smaller is nearer, in both senses. A plane word has these bits
/// on top and `guard_bits` below; set-up adds ½, so that dropping the guard bits rounds. With larger_is_nearer, the
/// whole word is complemented, which is linear too (~z = −z − 1). So both senses order all pixels in the same way and
/// draw the same picture.
template <int Bits, class StoredWord, DepthSense DepthOrder>
struct DepthFormat {
  using Word = StoredWord;
  static constexpr int bits = Bits;             ///< bits of a vertex depth, 16 or 24
  static constexpr int guard_bits = 32 - Bits;  ///< fraction bits of a plane word
  static constexpr DepthSense sense = DepthOrder;
  static constexpr bool smaller = sense == DepthSense::smaller_is_nearer;
  static constexpr int stored_shift = 32 - static_cast<int>(sizeof(Word)) * 8;  ///< plane word → stored word

  /// The range of vertex depths leaves room at its ends, so that rounding of a plane cannot wrap from near to far and
  /// the clear value lies outside. At 24 bits the rounding error is a few units in the largest pictures.
  static constexpr std::uint32_t nearest = Bits == 16 ? 0 : 16;
  static constexpr std::uint32_t farthest = Bits == 16 ? 65534 : (1u << 24) - 17;

  /// The stored word that every polygon hides.
  static constexpr Word clear = smaller ? static_cast<Word>(~Word{0}) : Word{0};

  /// The stored bits of a plane word.
  static constexpr std::uint32_t stored(std::uint32_t plane_word) { return plane_word >> stored_shift; }

  /// Whether a new depth hides a stored one. Of equal depths the stored one stays, so the polygon that was submitted
  /// first wins.
  static constexpr bool hides(std::uint32_t candidate, Word kept) {
    return smaller ? candidate < kept : candidate > kept;
  }

  /// The depth integer of a stored word without guard bits, as --depth-out shows it.
  static constexpr std::uint32_t integer(Word kept) {
    return sizeof(Word) == 4 ? static_cast<std::uint32_t>(kept) >> guard_bits : kept;
  }
};

/// 16 bits are stored. The 16 guard bits are only in the plane word.
template <DepthSense Sense = DepthSense::smaller_is_nearer>
using Depth16 = DepthFormat<16, std::uint16_t, Sense>;

/// 24 bits and 8 guard bits, all stored. Comparisons use the full word, so all exact algorithms draw the same picture.
template <DepthSense Sense = DepthSense::smaller_is_nearer>
using Depth24 = DepthFormat<24, std::uint32_t, Sense>;

}  // namespace spanline
