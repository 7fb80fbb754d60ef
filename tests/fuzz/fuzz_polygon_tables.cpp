// libFuzzer's entry: random polygon tables, by all exact algorithms at once.
#include <cstdio>
#include <cstdlib>

#include "polygon_bytes.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string fault = spanline::fuzz::fault_in(spanline::fuzz::decode({data, size}));
  if (!fault.empty()) {
    std::fprintf(stderr, "%s\n", fault.c_str());
    std::abort();
  }
  return 0;
}
