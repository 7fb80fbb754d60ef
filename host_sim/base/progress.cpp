#include "base/progress.hpp"

#include <unistd.h>

#include <cstdio>

namespace spanline::sim {

void Progress::show(std::size_t done, std::size_t total) {
  using namespace std::chrono_literals;
  const auto now = std::chrono::steady_clock::now();
  if (now - start_ < 1s || now - last_ < 100ms || isatty(STDERR_FILENO) == 0) return;
  last_ = now;
  shown_ = true;
  if (total > 0)
    std::fprintf(stderr, "\r\033[Kspanline: %s %zu of %zu", what_.c_str(), done, total);
  else
    std::fprintf(stderr, "\r\033[Kspanline: %s %.0f s", what_.c_str(),
                 std::chrono::duration<double>(now - start_).count());
}

void Progress::clear() {
  if (shown_) std::fputs("\r\033[K", stderr);
  shown_ = false;
}

}  // namespace spanline::sim
