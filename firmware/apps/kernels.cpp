// Kernels of different kinds between cycle markers, by which the cycle model of tests/qemu/cycles is held against
// rp2040js: each is one interval and one report. Prints their names in order, a line each.
#include <bunny.hpp>
#include <cstddef>
#include <cstdint>
#include <spanline/frame/ready_made_traits.hpp>

#include "board.hpp"
#include "cycle_markers.hpp"
#include "scenes/crc32.hpp"
#include "scenes/model_view.hpp"

extern "C" void* memcpy(void*, const void*, std::size_t);

namespace {

using namespace spanline;

std::uint32_t words[1024];
std::uint32_t other_words[1024];
volatile std::uint32_t sink;

void fill_words() {
  std::uint32_t value = 0x12345678;
  for (std::uint32_t& word : words) {
    value ^= value << 13;
    value ^= value >> 17;
    value ^= value << 5;
    word = value;
  }
}

/// Products and sums that wait for one another.
[[gnu::noinline]] void arithmetic() {
  std::uint32_t a = 1, b = 2;
  for (std::uint32_t i = 0; i < 2000; ++i) {
    a = a * b + i;
    b = (b ^ a) + (a >> 7);
  }
  sink = a + b;
}

/// Loads and stores by lists of registers.
[[gnu::noinline]] void copies() {
  for (int i = 0; i < 16; ++i) memcpy(other_words, words, sizeof words);
}

/// Calls that go deep: PUSH with lr, POP with pc.
[[gnu::noinline]] std::uint32_t fibonacci(std::uint32_t n) { return n < 2 ? n : fibonacci(n - 1) + fibonacci(n - 2); }

/// Branches that depend on data.
[[gnu::noinline]] void branches() {
  std::uint32_t steps = 0;
  for (std::uint32_t start = 1; start < 400; ++start) {
    for (std::uint32_t n = start; n != 1; n = (n & 1) != 0 ? 3 * n + 1 : n / 2) ++steps;
  }
  sink = steps;
}

/// Bytes from memory, and a table by index.
[[gnu::noinline]] void bytes() {
  scenes::Crc32 crc;
  for (const std::uint32_t word : words) crc.add(static_cast<std::uint16_t>(word));
  sink = crc.value();
}

/// The division routine of the compiler's library.
[[gnu::noinline]] void divisions() {
  std::uint32_t sum = 0;
  for (std::uint32_t i = 1; i < 1000; ++i) sum += words[i] / (words[i - 1] >> 12 | 1);
  sink = sum;
}

alignas(Arena::alignment) std::byte memory[100 * 1024];

/// Geometry and drawing of the bunny in bands of 16 lines.
[[gnu::noinline]] bool picture() {
  const Mesh& mesh = spanline_models::bunny;
  static Renderer<FlatTraits<Rgb565>> renderer(
      {.vertices = static_cast<std::uint32_t>(mesh.vertex_count()), .polygons = 1600, .active = 90}, memory);
  const scenes::ModelView view = scenes::model_view(mesh, Angle::from_degrees(30), 240, ShadingMode::flat);
  return renderer.begin(view.settings).ok() && renderer.add(mesh, view.transform, view.material).ok() &&
         renderer.draw([](const auto&) { return true; }).ok();
}

template <class Kernel>
void measure(const char* name, Kernel kernel) {
  board::cycles_start();
  kernel();
  board::cycles_stop();
  board::cycles_report();
  board::write(name);
  board::write("\n");
}

}  // namespace

int main() {
  fill_words();
  bool drawn = false;
  measure("arithmetic", arithmetic);
  measure("copies", copies);
  measure("calls", [] { sink = fibonacci(16); });
  measure("branches", branches);
  measure("bytes", bytes);
  measure("divisions", divisions);
  measure("picture", [&] { drawn = picture(); });
  return drawn ? 0 : 1;
}
