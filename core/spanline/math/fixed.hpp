#pragma once
#include <compare>
#include <concepts>
#include <cstdint>
#include <limits>

namespace spanline {

/// A fixed-point number, whose value is raw() / 2^FractionBits.
///
/// Formats cannot be mixed by accident: +, − and comparison require the same format on both sides, and `multiply` names
/// the format of its result. Sums and differences must not overflow; the caller chooses a format that holds them.
template <int FractionBits, std::signed_integral Rep = std::int32_t>
class Fixed {
 public:
  using rep = Rep;
  static constexpr int fraction_bits = FractionBits;
  static_assert(FractionBits >= 0 && FractionBits < std::numeric_limits<Rep>::digits + 1);

  constexpr Fixed() = default;

  /// The only way to make a Fixed from a raw integer.
  [[nodiscard]] static constexpr Fixed from_raw(Rep raw) { return Fixed(raw); }

  /// A whole number; |value| < 2^(digits − FractionBits).
  [[nodiscard]] static constexpr Fixed from_int(Rep value) {
    return Fixed(static_cast<Rep>(value * (Rep{1} << FractionBits)));
  }

  /// numerator / denominator, rounded to nearest (ties away from zero); denominator > 0, and |numerator| < 2^(62 −
  /// FractionBits).
  [[nodiscard]] static constexpr Fixed from_ratio(std::int64_t numerator, std::int64_t denominator) {
    const std::int64_t scaled = numerator * (std::int64_t{1} << FractionBits);
    const std::int64_t half = denominator / 2;
    return Fixed(static_cast<Rep>((scaled < 0 ? scaled - half : scaled + half) / denominator));
  }

  [[nodiscard]] constexpr Rep raw() const { return raw_; }

  /// The greatest whole number not above the value.
  [[nodiscard]] constexpr Rep floor() const { return static_cast<Rep>(raw_ >> FractionBits); }

  /// The nearest whole number, halves upwards.
  [[nodiscard]] constexpr Rep round() const {
    if constexpr (FractionBits == 0)
      return raw_;
    else
      return static_cast<Rep>((raw_ + (Rep{1} << (FractionBits - 1))) >> FractionBits);
  }

  /// The same value in another format, rounded to nearest, halves upwards.
  template <class Result>
  [[nodiscard]] constexpr Result convert() const {
    constexpr int shift = FractionBits - Result::fraction_bits;
    const auto wide = static_cast<std::int64_t>(raw_);
    if constexpr (shift > 0) {
      return Result::from_raw(static_cast<typename Result::rep>((wide + (std::int64_t{1} << (shift - 1))) >> shift));
    } else {
      return Result::from_raw(static_cast<typename Result::rep>(wide * (std::int64_t{1} << -shift)));
    }
  }

  constexpr Fixed operator-() const { return Fixed(static_cast<Rep>(-raw_)); }
  constexpr Fixed& operator+=(Fixed other) { return *this = *this + other; }
  constexpr Fixed& operator-=(Fixed other) { return *this = *this - other; }
  friend constexpr Fixed operator+(Fixed a, Fixed b) { return Fixed(static_cast<Rep>(a.raw_ + b.raw_)); }
  friend constexpr Fixed operator-(Fixed a, Fixed b) { return Fixed(static_cast<Rep>(a.raw_ - b.raw_)); }
  friend constexpr auto operator<=>(Fixed a, Fixed b) = default;

 private:
  constexpr explicit Fixed(Rep raw) : raw_(raw) {}
  Rep raw_ = 0;
};

/// a·b in the format that the caller names, rounded to nearest, halves upwards. The product of the raw values must fit
/// 64 bits.
template <class Result, class A, class B>
[[nodiscard]] constexpr Result multiply(A a, B b) {
  constexpr int shift = A::fraction_bits + B::fraction_bits - Result::fraction_bits;
  static_assert(shift >= 0 && shift < 63, "the product has fewer fraction bits than its result");
  std::int64_t product = static_cast<std::int64_t>(a.raw()) * b.raw();
  if constexpr (shift > 0) product = (product + (std::int64_t{1} << (shift - 1))) >> shift;
  return Result::from_raw(static_cast<typename Result::rep>(product));
}

using Q16_16 = Fixed<16>;              ///< world units: ±32768, steps of 1/65536
using Q2_30 = Fixed<30>;               ///< directions, sines and rotation matrices: [−2, 2)
using Q12_4 = Fixed<4, std::int16_t>;  ///< screen x and y, pixels: [−2048, 2048), steps of 1/16

namespace detail {
/// This function is declared but never defined. A call to it is no constant expression, so a literal with any character
/// that is not part of a decimal number does not compile.
void literal_is_not_a_decimal_number();

/// Converts decimal text such as "12.375" to a Fixed, rounded to nearest. Any other text does not compile.
template <class Format>
constexpr Format parse_decimal(const char* text) {
  std::int64_t whole = 0;
  std::int64_t numerator = 0;
  std::int64_t denominator = 1;
  bool fraction = false;
  for (; *text != '\0'; ++text) {
    if (*text == '\'') continue;
    if (*text == '.') {
      fraction = true;
      continue;
    }
    const int digit = *text - '0';
    if (digit < 0 || digit > 9) literal_is_not_a_decimal_number();
    if (!fraction) {
      whole = whole * 10 + digit;
    } else if (denominator < 1'000'000'000) {
      numerator = numerator * 10 + digit;
      denominator *= 10;
    }
  }
  using Rep = typename Format::rep;
  const auto scale = std::int64_t{1} << Format::fraction_bits;
  return Format::from_raw(static_cast<Rep>(whole * scale + (numerator * scale * 2 + denominator) / (denominator * 2)));
}

/// The value of a literal. It is a variable because clang 14 calls a consteval operator at run time when a template
/// uses it.
template <class Format, char... Digits>
inline constexpr Format literal = [] {
  constexpr char text[] = {Digits..., '\0'};
  return parse_decimal<Format>(text);
}();
}  // namespace detail

inline namespace literals {
/// `1.5_q16`: a Q16.16 constant, read from its decimal digits at compile time.
template <char... Digits>
constexpr Q16_16 operator""_q16() {
  return detail::literal<Q16_16, Digits...>;
}
/// `0.75_q24`: a Q8.24 constant, the format of scales.
template <char... Digits>
constexpr Fixed<24> operator""_q24() {
  return detail::literal<Fixed<24>, Digits...>;
}
/// `0.7071_q30`: a Q2.30 constant.
template <char... Digits>
constexpr Q2_30 operator""_q30() {
  return detail::literal<Q2_30, Digits...>;
}
}  // namespace literals

}  // namespace spanline
