// Draws the scenes of the self-test that fit the board's memory and prints a line for each:
// `selftest <scene> <visibility> <depth> <band> <crc> <crc of the depths>`. tests/selftest draws the same on the host.
#include <bunny.hpp>
#include <span>
#include <teapot.hpp>

#include "board.hpp"
#include "picture_memory.hpp"
#include "scenes/selftest_registry.hpp"
#include "scenes/selftest_runner.hpp"

namespace {

using namespace spanline;

alignas(Arena::alignment) std::byte memory[board::picture_memory];

/// A model, where a scene that this board draws shows it; anything else otherwise, so that it is not linked.
template <const Mesh& Model>
constexpr const Mesh& model_for(const char* name) {
  return scenes::selftest_shows(name, board::picture_memory) ? Model : scenes::torus;
}

constexpr scenes::SelftestModels models{model_for<spanline_models::bunny>("bunny"),
                                        model_for<spanline_models::teapot>("teapot")};

void print(const char* text) {
  board::write(" ");
  board::write(text);
}

void print_line(const scenes::SelftestScene& scene, const char* visibility, const char* renderer, unsigned band,
                const scenes::SelftestResult& result) {
  board::write("selftest");
  print(scene.name);
  print(visibility);
  print(renderer);
  print("");
  board::write_unsigned(band);
  print("");
  board::write_hex(result.crc);
  print("");
  board::write_hex(result.depth);
  board::write("\n");
}

void print_failure(const scenes::SelftestScene& scene, Status status) {
  board::write("selftest:");
  print(scene.name);
  print(to_string(status.fault));
  print(to_string(status.pool));
  print("wanted ");
  board::write_unsigned(status.wanted);
  board::write("\n");
}

}  // namespace

int main() {
  board::write("selftest memory ");
  board::write_unsigned(board::picture_memory);
  board::write("\n");
  bool good = true;
  scenes::for_each_selftest_run(
      board::picture_memory, [&](const scenes::SelftestScene& scene, const scenes::SelftestRun& run) {
        const scenes::SelftestResult result =
            scenes::draw_selftest<board::picture_memory>(scene, run, models, memory, [](const auto&) {});
        print_line(scene, scenes::visibility_of(scene, run), to_string(run.renderer), run.band, result);
        if (scenes::as_expected(scene, result.status)) return;
        print_failure(scene, result.status);
        good = false;
      });
  if constexpr (board::picture_memory >= scenes::memory_for_every_algorithm)
    scenes::for_each_registry_run(board::picture_memory, [&](const AlgorithmEntry& entry,
                                                             const scenes::SelftestScene& scene, std::uint16_t band) {
      const scenes::RegistryDrawer drawer = scenes::registry_drawer_of(entry);
      const scenes::SelftestResult result = drawer.draw(scene, band, models, std::span(memory));
      print_line(scene, entry.name, "24-layers", band, result);
      if (result.status.ok()) return;
      print_failure(scene, result.status);
      good = false;
    });
  board::write("selftest stack ");
  board::write_unsigned(board::stack_used());
  board::write(" of ");
  board::write_unsigned(board::stack_size());
  board::write("\n");
  return good ? 0 : 1;
}
