// What the firmware's self-test must print, drawn on this host: the lines of a board with so many bytes to spare, or of
// all scenes. With a folder, also a PNG of each scene.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <string_view>

#include "host_run.hpp"
#include "image/png.hpp"

namespace {

using namespace spanline;

struct Options {
  std::uint32_t memory = std::numeric_limits<std::uint32_t>::max();
  std::string pictures;
};

sim::Picture picture_of(const scenes::SelftestScene& scene, const scenes::SelftestRun& run,
                        const test::HostPicture& drawn) {
  sim::Picture picture(scene.capacity.width, scene.capacity.height);
  picture.pixels = test::colours_of(drawn, run);
  return picture;
}

void write(const std::string& path, const sim::Picture& picture) {
  const std::vector<std::byte> png = sim::encode_png(picture);
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(png.data()), static_cast<std::streamsize>(png.size()));
  if (!file) throw std::runtime_error("cannot write " + path);
}

Options parse(int count, char** arguments) {
  Options options;
  for (int i = 1; i < count; i += 2) {
    const std::string_view name = arguments[i];
    if (i + 1 == count) throw std::runtime_error(std::string(name) + " wants a value");
    if (name == "--memory")
      options.memory = static_cast<std::uint32_t>(std::stoul(arguments[i + 1]));
    else if (name == "--pictures")
      options.pictures = arguments[i + 1];
    else
      throw std::runtime_error("usage: selftest_host [--memory BYTES] [--pictures FOLDER]");
  }
  return options;
}

void run(const Options& options) {
  if (!options.pictures.empty()) std::filesystem::create_directories(options.pictures);
  scenes::for_each_selftest_run(options.memory,
                                [&](const scenes::SelftestScene& scene, const scenes::SelftestRun& run) {
                                  const test::HostPicture drawn = test::draw_on_host(scene, run);
                                  const scenes::SelftestResult& result = drawn.result;
                                  std::printf("selftest %s %s %s %u %08x %08x\n", scene.name, visibility_of(scene, run),
                                              to_string(run.renderer), unsigned{run.band}, result.crc, result.depth);
                                  if (!as_expected(scene, result.status))
                                    throw std::runtime_error(std::string(scene.name) + ": a pool is wrong");
                                  if (!options.pictures.empty() && &run == scene.runs.data())
                                    write(options.pictures + "/" + scene.name + ".png", picture_of(scene, run, drawn));
                                });
  scenes::for_each_registry_run(
      options.memory, [](const AlgorithmEntry& entry, const scenes::SelftestScene& scene, std::uint16_t band) {
        const scenes::SelftestResult result = test::draw_on_host(entry, scene, band);
        std::printf("selftest %s %s 24-layers %u %08x %08x\n", scene.name, entry.name, unsigned{band}, result.crc,
                    result.depth);
        if (!result.status.ok())
          throw std::runtime_error(std::string(scene.name) + " by " + entry.name + ": a pool is full");
      });
}

}  // namespace

int main(int count, char** arguments) {
  try {
    run(parse(count, arguments));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "selftest_host: %s\n", error.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
