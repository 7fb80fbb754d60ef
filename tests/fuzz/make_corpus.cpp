// Writes the fuzzer's seed corpus into a folder: small scenes of the contract suite's kinds.
#include <cstdio>
#include <fstream>
#include <functional>
#include <string>

#include "generators.hpp"
#include "polygon_bytes.hpp"

namespace spanline::fuzz {
namespace {

int write_corpus(const std::string& folder) {
  using namespace contract;
  const std::function<Scene(Random&)> makers[] = {mixed_soup,      penetrating_soup, extreme_depths, shared_grids,
                                                  coplanar_ties,   quads_on_centres, cyclic_bars,    depth_layers,
                                                  nested_polygons, shared_corners};
  constexpr std::size_t seeds_a_maker = 4, most = 60;  // triangles: small inputs change faster
  int number = 0;
  for (const auto& make : makers)
    for (std::uint32_t seed = 1; seed <= seeds_a_maker; ++seed, ++number) {
      Random random(seed);
      Scene scene = make(random);
      if (scene.triangles.size() > most) scene.triangles.resize(most);
      const auto bytes =
          encode(scene, 1 + number % 16, static_cast<std::uint8_t>(number % 3 == 0 ? 8 : 0), number % 2 == 1);
      std::ofstream file(folder + "/" + std::to_string(number), std::ios::binary);
      file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
      if (!file.flush()) return 1;
    }
  return 0;
}

}  // namespace
}  // namespace spanline::fuzz

int main(int argc, char** argv) {
  if (argc == 2 && spanline::fuzz::write_corpus(argv[1]) == 0) return 0;
  std::fprintf(stderr, "usage: fuzz_corpus FOLDER, which must exist\n");
  return 1;
}
