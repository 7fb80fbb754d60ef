// Writes seeds for fuzz_api into a folder: random bytes, long enough for a few meshes, since every byte means
// something.
#include <cstdio>
#include <fstream>
#include <string>

#include "support/random.hpp"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: fuzz_frame_corpus FOLDER, which must exist\n");
    return 1;
  }
  spanline::test::Random random(1);
  for (int i = 0; i < 100; ++i) {
    std::ofstream file(std::string(argv[1]) + "/" + std::to_string(i), std::ios::binary);
    for (int left = random.between(100, 2000); left > 0; --left) file.put(static_cast<char>(random.between(0, 255)));
    if (!file.flush()) return 1;
  }
  return 0;
}
