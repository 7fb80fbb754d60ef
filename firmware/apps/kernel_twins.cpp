// Kernels that this core has in a form of its own, against their portable twins on random input: the same words must
// come out. Prints `twins <kernel>` for each, and ends with 1 where one differs.
#include "twins/row_twins.hpp"
#include "twins/texel_twins.hpp"
#include "twins/texture_block_twins.hpp"
#include "twins/vertex_twins.hpp"
#include "twins/word_twins.hpp"

int main() {
  using namespace twins;
  bool alike = true;
  [[maybe_unused]] const auto hold = [&](const char* kernel, std::uint32_t rounds, auto compare) {
    alike &= all_alike(kernel, rounds, compare);
  };
#if defined(__ARM_ARCH_6M__)
  hold("flat rows, short", 500, flat_rows_alike<ActiveTriangle::Size::small>);
  hold("flat rows, long", 500, flat_rows_alike<ActiveTriangle::Size::medium>);
  hold("ramp rows", 500, ramp_rows_alike);
  hold("texel blocks, whole", 2000, [](Random& random) { return texel_blocks_alike(random, Part::whole); });
  hold("texel blocks, leftwards", 2000, [](Random& random) { return texel_blocks_alike(random, Part::left); });
  hold("texel blocks, rightwards", 2000, [](Random& random) { return texel_blocks_alike(random, Part::right); });
  hold("texel blocks, middle", 1000, [](Random& random) { return texel_blocks_alike(random, Part::middle); });
  hold("texel blocks, any", 2000, [](Random& random) { return texel_blocks_alike(random, Part::any); });
  hold("vertices", 2000, vertices_alike);
#endif
#if defined(__arm__)
  hold("texture blocks", 5000, texture_blocks_alike);
  hold("fills", 3000, fills_alike);
#endif
#if defined(__ARM_ARCH_6M__) || defined(__ARM_FEATURE_SIMD32)
  hold("areas", 20000, areas_alike);
#endif
#if defined(__ARM_FEATURE_SIMD32)
  hold("paired depths", 5000, paired_depths_alike);
  hold("packed depths", 5000, packed_depths_alike);
#endif
#if defined(__ARM_FEATURE_DSP)
  hold("reciprocal shares", 20000, reciprocal_shares_alike);
#endif
#if defined(__ARM_FEATURE_SAT)
  hold("clamps", 20000, clamps_alike);
#endif
  return alike ? 0 : 1;
}
