// Runs into an instruction that no core has. The test looks for the address of fault_on_purpose in the report.
#include <board.hpp>

extern "C" [[gnu::noinline]] void fault_on_purpose() { __builtin_trap(); }

int main() {
  spanline::board::write("about to fault\n");
  fault_on_purpose();
  return 0;
}
