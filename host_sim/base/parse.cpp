#include "base/parse.hpp"

#include <array>
#include <charconv>
#include <cmath>

#include "base/failure.hpp"

namespace spanline::sim {
namespace {

UsageError bad_value(const std::string& option, const std::string& text, const std::string& wanted) {
  return UsageError(option + ": '" + text + "' is not " + wanted);
}

/// Reads the whole of `text`, without regard to the locale.
template <class Number>
bool read_all(std::string_view text, Number& value) {
  if (text.starts_with('+')) text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size();
}

}  // namespace

double parse_number(const std::string& option, const std::string& text) {
  double value = 0;
  if (!read_all(text, value) || !std::isfinite(value)) throw bad_value(option, text, "a finite number");
  return value;
}

int parse_integer(const std::string& option, const std::string& text, int lowest, int highest) {
  int value = 0;
  if (!read_all(text, value) || value < lowest || value > highest)
    throw bad_value(option, text, "a whole number from " + std::to_string(lowest) + " to " + std::to_string(highest));
  return value;
}

Size parse_size(const std::string& option, const std::string& text) {
  Size size;
  const std::string_view view = text;
  const std::size_t cross = view.find('x');
  const auto good = [](int value) { return value >= 1 && value <= greatest_size; };
  if (cross == std::string_view::npos || !read_all(view.substr(0, cross), size.width) ||
      !read_all(view.substr(cross + 1), size.height) || !good(size.width) || !good(size.height))
    throw bad_value(option, text, "a size WIDTHxHEIGHT with both from 1 to " + std::to_string(greatest_size));
  return size;
}

Vector3 parse_vector(const std::string& option, const std::string& text) {
  std::array<double, 3> values{};
  std::string_view rest = text;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t comma = i < 2 ? rest.find(',') : rest.size();
    if (comma == std::string_view::npos || !read_all(rest.substr(0, comma), values[i]) || !std::isfinite(values[i]))
      throw bad_value(option, text, "three finite numbers X,Y,Z");
    rest.remove_prefix(i < 2 ? comma + 1 : comma);
  }
  return {values[0], values[1], values[2]};
}

Rgb888 parse_colour(const std::string& option, const std::string& text) {
  std::string_view digits = text;
  if (digits.starts_with('#')) digits.remove_prefix(1);
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
  if (digits.size() != 6 || error != std::errc{} || end != digits.data() + digits.size())
    throw bad_value(option, text, "a colour RRGGBB");
  const auto channel = [value](int shift) { return static_cast<std::uint8_t>((value >> shift) & 255); };
  return {channel(16), channel(8), channel(0)};
}

}  // namespace spanline::sim
