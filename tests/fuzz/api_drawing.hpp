#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "api_run.hpp"
#include "spanline/frame/pick.hpp"
#include "spanline/frame/renderer.hpp"

namespace spanline::fuzz {

constexpr std::size_t most_bytes = 8u << 20, guard_bytes = 64;

/// What one frame came to.
struct Outcome {
  Statuses statuses;  ///< begin, each add, draw
  std::vector<std::uint32_t> pixels;

  [[nodiscard]] Status drawn() const { return statuses.empty() ? Status{} : statuses.back(); }
  friend bool operator==(const Outcome&, const Outcome&) = default;
};

/// What came of a frame, by whom.
struct Drawn {
  std::string name;
  Outcome outcome;
};

/// What a frame comes to by renderers that draw alike, and what was wrong.
struct Run {
  std::vector<Drawn> all;
  Statuses told;  ///< of calls beside those of the outcomes
  std::string fault;
};

/// By renderers that have all shaders, of all families of exact algorithms.
[[nodiscard]] Run draw_everything(const ApiFrame& frame);
/// By one with few shaders.
[[nodiscard]] Run draw_plain(const ApiFrame& frame);
/// By one that must tell what it does not show without layers.
[[nodiscard]] Run draw_opaque(const ApiFrame& frame);
/// By one whose algorithm works in the world.
[[nodiscard]] Run draw_world(const ApiFrame& frame);
/// By those that draw numbers of triangles, and pick one.
[[nodiscard]] Run draw_ids(const ApiFrame& frame);
/// By an order of depth, which draws some scenes otherwise than exact algorithms do: with all shaders, and ids.
[[nodiscard]] Run draw_in_order(const ApiFrame& frame);
[[nodiscard]] Run draw_ids_in_order(const ApiFrame& frame);

/// Memory with a border that nobody may write to.
class Guarded {
 public:
  Guarded(std::size_t size, unsigned misaligned, std::uint8_t filling)
      : bytes_(size + misaligned + 2 * guard_bytes, std::byte{filling}), first_(guard_bytes + misaligned), size_(size) {
    std::ranges::fill(before(), border);
    std::ranges::fill(behind(), border);
  }
  [[nodiscard]] std::span<std::byte> memory() { return std::span(bytes_).subspan(first_, size_); }
  [[nodiscard]] bool intact() {
    const auto is_border = [](std::byte byte) { return byte == border; };
    return std::ranges::all_of(before(), is_border) && std::ranges::all_of(behind(), is_border);
  }

 private:
  [[nodiscard]] std::span<std::byte> before() { return std::span(bytes_).first(first_); }
  [[nodiscard]] std::span<std::byte> behind() { return std::span(bytes_).subspan(first_ + size_); }

  static constexpr std::byte border{0xa5};
  std::vector<std::byte> bytes_;
  std::size_t first_, size_;
};

/// Draws a frame by renderers of one kind, and finds fault with them.
template <class Traits>
class Drawing {
 public:
  Drawing(const ApiFrame& frame, Run& run) : frame_(frame), run_(run) {}

  /// In bands of both heights.
  void draw(const char* name) {
    std::uint8_t filling = 0;
    for (const std::uint16_t lines : {frame_.capacity.band_lines, frame_.other_lines}) {
      fault_.clear();
      run_.all.push_back(
          {std::string(name) + ", bands of " + std::to_string(lines), outcome_in_bands_of(lines, filling)});
      if (!fault_.empty() && run_.fault.empty()) run_.fault = run_.all.back().name + ": " + fault_;
      filling = 0xff;
    }
  }

 private:
  static constexpr bool has_ids = std::same_as<typename Traits::Format, PolygonIds>;

  Outcome outcome_in_bands_of(std::uint16_t lines, std::uint8_t filling) {
    Capacity capacity = frame_.capacity;
    capacity.band_lines = lines;
    std::size_t needed = Renderer<Traits>::takes(capacity) ? Renderer<Traits>::bytes_needed(capacity) : 0;
    if (needed > most_bytes) needed = 0;  // too little for it
    Guarded guarded(needed - std::min(needed, frame_.bytes_missing), frame_.misaligned, filling);
    Renderer<Traits> renderer(capacity, guarded.memory());
    Outcome first = draw_once(renderer);
    if (!(draw_once(renderer) == first)) fault_ = "another picture, or other statuses, the second time";
    const bool sink_failed = first.drawn().fault == Fault::sink_failed;
    const Outcome steps = draw_by_steps(renderer);
    if (!sink_failed && !(steps == first)) fault_ = "another picture, or other statuses, by steps";
    if constexpr (has_ids) pick_one(renderer, first);
    if (!guarded.intact()) fault_ = "bytes outside the memory were written";
    if (!renderer.status().ok() && first.drawn().ok()) fault_ = "a renderer that was refused draws";
    if (first.drawn().ok() && first.pixels.size() != std::size_t{capacity.width} * capacity.height)
      fault_ = "not all of the picture";
    return first;
  }

  Outcome add_all(Renderer<Traits>& renderer) {
    Outcome outcome;
    const auto note = [&](Status status) { outcome.statuses.push_back(status); };
    if (!frame_.without_begin) note(renderer.begin(frame_.settings));
    if (frame_.too_many_triangles)
      note(renderer.add_screen({frame_.screen_vertices.data(), std::size_t{3} * fan_flag}, frame_.screen_colours));
    if (!frame_.screen_corners.empty())
      note(renderer.add_screen(frame_.screen_vertices, frame_.screen_corners, frame_.screen_colours,
                               frame_.screen_material));
    else if (!frame_.screen_vertices.empty())
      note(renderer.add_screen(frame_.screen_vertices, frame_.screen_colours, frame_.screen_material));
    if (frame_.in_order) {
      std::vector<OrderedInstance> instances;
      for (const contract::Part& part : frame_.parts) instances.push_back({part.mesh, part.transform, part.material});
      note(renderer.add_in_order(ListedOrder(frame_.order), instances));
      return outcome;
    }
    for (const contract::Part& part : frame_.parts) note(renderer.add(*part.mesh, part.transform, part.material));
    return outcome;
  }

  Outcome draw_once(Renderer<Traits>& renderer) {
    Outcome outcome = add_all(renderer);
    unsigned bands = 0;
    outcome.statuses.push_back(renderer.draw([&](const auto& band) {
      outcome.pixels.insert(outcome.pixels.end(), band.pixels.begin(), band.pixels.end());
      return ++bands != frame_.sink_fails_at;
    }));
    return outcome;
  }

  /// The same by the steps of `draw`, with a few out of their turn before them: those do nothing and say so.
  Outcome draw_by_steps(Renderer<Traits>& renderer) {
    struct NoSink {
    } sink;
    Outcome outcome = add_all(renderer);
    for (const Status early : {renderer.end_bands(), renderer.clear_band(renderer.capacity().bands())}) {
      if (early.ok()) fault_ = "a step out of its turn was taken";
      run_.told.push_back(early);
    }
    if (!renderer.draw_band(0, sink).pixels.empty()) fault_ = "a band was drawn before its turn";
    const Status started = renderer.start_bands();
    for (std::uint32_t band = 0; band < renderer.capacity().bands(); ++band) {
      if (renderer.clear_band(band) != started) fault_ = "a band was cleared in a frame that did not start, or not";
      const auto view = renderer.draw_band(band, sink);
      outcome.pixels.insert(outcome.pixels.end(), view.pixels.begin(), view.pixels.end());
    }
    outcome.statuses.push_back(renderer.end_bands());
    return outcome;
  }

  /// What is picked is what the picture shows.
  void pick_one(Renderer<Traits>& renderer, const Outcome& picture) {
    (void)add_all(renderer);
    Picked<typename Traits::Depth> picked;
    const Status status = pick(renderer, frame_.picked_column, frame_.picked_row, picked);
    run_.told.push_back(status);
    const Capacity& capacity = renderer.capacity();
    const bool inside = frame_.picked_column < capacity.width && frame_.picked_row < capacity.height;
    if (inside == (status.fault == Fault::outside_picture)) fault_ = "a pixel outside was picked, or one inside not";
    if (!inside || !picture.drawn().ok()) return;
    if (!status.ok() ||
        picked.id != picture.pixels[std::size_t{frame_.picked_row} * capacity.width + frame_.picked_column])
      fault_ = "another triangle was picked than is seen";
  }

  const ApiFrame& frame_;
  Run& run_;
  std::string fault_;  ///< with bands of this height
};

}  // namespace spanline::fuzz
