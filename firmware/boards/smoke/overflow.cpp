// Uses more stack than there is. The test looks for a report that says so.
#include <board.hpp>

namespace {

[[gnu::noinline]] std::uint32_t dive(std::uint32_t depth) {
  volatile std::uint32_t frame[16] = {depth};
  return depth == 0 ? frame[0] : dive(depth - 1) + frame[0];
}

}  // namespace

int main() {
  spanline::board::write("about to overflow the stack\n");
  return static_cast<int>(dive(1'000'000));
}
