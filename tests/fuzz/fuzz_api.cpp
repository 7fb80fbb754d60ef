// libFuzzer's entry: whole frames through the public API, by several renderers.
#include <cstdio>
#include <cstdlib>

#include "api_run.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  spanline::fuzz::Statuses told;
  const std::string fault = spanline::fuzz::fault_in(spanline::fuzz::decode_frame({data, size}), told);
  if (!fault.empty()) {
    std::fprintf(stderr, "%s\n", fault.c_str());
    std::abort();
  }
  return 0;
}
