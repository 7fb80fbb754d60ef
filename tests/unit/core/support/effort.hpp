#pragma once
#include <cstdlib>
#include <string_view>

namespace spanline::test {

/// The size of a random sample of whose mean something is expected: as asked in every build, since a part of it has
/// another mean, and ten times that where the environment's SPANLINE_TEST_LENGTH is "long".
[[nodiscard]] inline int sample_size(int wanted) {
  const char* length = std::getenv("SPANLINE_TEST_LENGTH");
  return length != nullptr && std::string_view(length) == "long" ? wanted * 10 : wanted;
}

/// How often a random test repeats: as a sample, but a sixteenth of it under sanitizers. At least once.
[[nodiscard]] inline int rounds(int wanted) {
#if defined(SPANLINE_SANITIZERS)
  wanted = wanted < 16 ? 1 : wanted / 16;
#endif
  return sample_size(wanted);
}

/// A step over a range that is walked whole in a plain build, and thinly under sanitizers.
[[nodiscard]] inline unsigned stride([[maybe_unused]] unsigned under_sanitizers) {
#if defined(SPANLINE_SANITIZERS)
  return under_sanitizers;
#else
  return 1;
#endif
}

}  // namespace spanline::test
