#pragma once
#include <cstdlib>
#include <string_view>

namespace spanline::test {

/// How often a random test repeats: as asked in a plain build, an eighth of it under sanitizers, and ten times as often
/// where the environment's SPANLINE_TEST_LENGTH is "long". At least once.
[[nodiscard]] inline int rounds(int wanted) {
#if defined(__SANITIZE_ADDRESS__)
  wanted = wanted < 8 ? 1 : wanted / 8;
#endif
  const char* length = std::getenv("SPANLINE_TEST_LENGTH");
  return length != nullptr && std::string_view(length) == "long" ? wanted * 10 : wanted;
}

/// A step over a range that is walked whole in a plain build, and thinly under sanitizers.
[[nodiscard]] inline unsigned stride([[maybe_unused]] unsigned under_sanitizers) {
#if defined(__SANITIZE_ADDRESS__)
  return under_sanitizers;
#else
  return 1;
#endif
}

}  // namespace spanline::test
