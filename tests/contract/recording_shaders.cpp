#include "recording_shaders.hpp"

#include <algorithm>
#include <ostream>
#include <span>
#include <stdexcept>

#include "spanline/shade/shader_list.hpp"
#include "spanline/visibility/span/spanning_scan_line.hpp"
#include "support/studio.hpp"

namespace spanline::contract {
namespace {

/// What is being written: set while a scene is drawn.
struct Recorder {
  std::span<std::uint32_t> band;  ///< the colour band's memory
  std::vector<std::uint32_t> times;
  std::vector<Span> spans;  ///< `row` counts within the band
  std::size_t outside = 0;
  int width = 0;

  void note(std::uint32_t id, std::uint32_t count, const std::uint32_t* pixels) {
    const std::ptrdiff_t begin = pixels - band.data();
    if (count == 0 || begin < 0 || static_cast<std::size_t>(begin) + count > times.size()) {
      ++outside;
      return;
    }
    const auto first = static_cast<std::size_t>(begin);
    for (std::size_t i = first; i < first + count; ++i) ++times[i];
    const int row = static_cast<int>(begin) / width, column = static_cast<int>(begin) % width;
    spans.push_back({row, column, column + static_cast<int>(count), id});
  }
};
Recorder* recorder = nullptr;

/// Ids, written nowhere but into the record.
struct RecordingShaders : ShaderList<IdShader> {
  template <class S>
  static void fill(const S& surface, std::int32_t column, std::uint32_t count, std::uint32_t* pixels) {
    recorder->note(surface.source(column).get(), count, pixels);
  }
  static void fill_apart(std::uint32_t value, std::uint32_t count, std::uint32_t* pixels) {
    recorder->note(value, count, pixels);
  }
};

using Traits = RendererTraits<PolygonIds, RecordingShaders, Depth24<>, Spanning>;

/// Empties the record before each band, and takes it down behind.
struct Sink {
  Renderer<Traits>& renderer;
  Recorder& record;
  Written& written;
  std::vector<Span>& spans;

  bool acquire(unsigned buffer) {
    record.band = renderer.colour_band(buffer);
    record.times.assign(record.band.size(), 0);
    record.spans.clear();
    return true;
  }
  template <class Band>
  bool operator()(const Band& band) {
    const auto rest = record.times.begin() + static_cast<std::ptrdiff_t>(band.pixels.size());
    written.times.insert(written.times.end(), record.times.begin(), rest);
    for (auto beyond = rest; beyond != record.times.end(); ++beyond) record.outside += *beyond;
    for (Span span : record.spans) {
      span.row += band.y0;
      spans.push_back(span);
    }
    return true;
  }
};

Written record_scene(const Scene& scene, int band_lines, std::uint32_t active, std::vector<Span>& spans) {
  Capacity capacity = test::screen_capacity(scene.width, scene.height, scene.triangles.size(), band_lines);
  capacity.awake = active;
  test::Studio<Traits> studio(capacity);
  const auto vertices = test::vertices_of(scene.triangles, 24, scene.width, scene.height);
  const std::vector<std::uint16_t> colours(scene.triangles.size());
  studio.begin(scene.settings);
  studio.add_screen(vertices, colours);
  if (!studio.status().ok()) throw std::logic_error("the scene was not taken");
  Recorder record;
  record.width = scene.width;
  recorder = &record;
  Written written;
  // A pool that runs full is a status of its own, which others look at.
  (void)studio.renderer().draw(Sink{studio.renderer(), record, written, spans});
  recorder = nullptr;
  written.outside = record.outside;
  return written;
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const Span& span) {
  return out << "row " << span.row << " [" << span.begin << ", " << span.end << ") of " << span.id;
}

Written count_writes(const Scene& scene, int band_lines, std::uint32_t active) {
  std::vector<Span> spans;
  return record_scene(scene, band_lines, active, spans);
}

std::vector<Span> spans_of(const Scene& scene) {
  std::vector<Span> spans;
  (void)record_scene(scene, 1, static_cast<std::uint32_t>(scene.triangles.size()), spans);
  return spans;
}

}  // namespace spanline::contract
