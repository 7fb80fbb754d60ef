#include "api_run.hpp"

#include <algorithm>
#include <cstddef>

#include "spanline/frame/ready_made_traits.hpp"
#include "spanline/frame/renderer.hpp"

namespace spanline::fuzz {
namespace {

constexpr std::size_t most_bytes = 8u << 20, guard_bytes = 64;

/// What one frame came to.
struct Outcome {
  Statuses statuses;  ///< begin, each add, draw
  std::vector<std::uint16_t> pixels;

  [[nodiscard]] Status drawn() const { return statuses.empty() ? Status{} : statuses.back(); }
  friend bool operator==(const Outcome&, const Outcome&) = default;
};

template <class Traits>
Outcome add_all(Renderer<Traits>& renderer, const ApiFrame& frame) {
  Outcome outcome;
  const auto note = [&](Status status) { outcome.statuses.push_back(status); };
  if (!frame.without_begin) note(renderer.begin(frame.settings));
  if (!frame.screen_vertices.empty())
    note(renderer.add_screen(frame.screen_vertices, frame.screen_colours, frame.screen_material));
  for (const contract::Part& part : frame.parts) note(renderer.add(*part.mesh, part.transform, part.material));
  return outcome;
}

template <class Traits>
Outcome draw_once(Renderer<Traits>& renderer, const ApiFrame& frame) {
  Outcome outcome = add_all(renderer, frame);
  unsigned bands = 0;
  outcome.statuses.push_back(renderer.draw([&](const auto& band) {
    outcome.pixels.insert(outcome.pixels.end(), band.pixels.begin(), band.pixels.end());
    return ++bands != frame.sink_fails_at;
  }));
  return outcome;
}

/// The same by the steps of `draw`, with a few out of their turn before them: those do nothing and say so.
template <class Traits>
Outcome draw_by_steps(Renderer<Traits>& renderer, const ApiFrame& frame, std::string& fault, Statuses& told) {
  struct NoSink {
  } sink;
  Outcome outcome = add_all(renderer, frame);
  for (const Status early : {renderer.end_bands(), renderer.clear_band(renderer.capacity().bands())}) {
    if (early.ok()) fault = "a step out of its turn was taken";
    told.push_back(early);
  }
  if (!renderer.draw_band(0, sink).pixels.empty()) fault = "a band was drawn before its turn";
  const Status started = renderer.start_bands();
  for (std::uint32_t band = 0; band < renderer.capacity().bands(); ++band) {
    if (renderer.clear_band(band) != started) fault = "a band was cleared in a frame that did not start, or not";
    const auto view = renderer.draw_band(band, sink);
    outcome.pixels.insert(outcome.pixels.end(), view.pixels.begin(), view.pixels.end());
  }
  outcome.statuses.push_back(renderer.end_bands());
  return outcome;
}

/// Memory with a border that nobody may write to.
class Guarded {
 public:
  Guarded(std::size_t size, unsigned misaligned, std::uint8_t filling)
      : bytes_(size + misaligned + 2 * guard_bytes, std::byte{filling}), first_(guard_bytes + misaligned), size_(size) {
    for (std::size_t i = 0; i < bytes_.size(); ++i)
      if (i < first_ || i >= first_ + size_) bytes_[i] = border;
  }
  [[nodiscard]] std::span<std::byte> memory() { return std::span(bytes_).subspan(first_, size_); }
  [[nodiscard]] bool intact() const {
    for (std::size_t i = 0; i < bytes_.size(); ++i)
      if ((i < first_ || i >= first_ + size_) && bytes_[i] != border) return false;
    return true;
  }

 private:
  static constexpr std::byte border{0xa5};
  std::vector<std::byte> bytes_;
  std::size_t first_, size_;
};

template <class Traits>
Outcome draw_by(const ApiFrame& frame, std::uint16_t lines, std::uint8_t filling, std::string& fault, Statuses& told) {
  Capacity capacity = frame.capacity;
  capacity.band_lines = lines;
  const std::size_t needed =
      capacity.valid() && capacity.polygons < 1u << 20 ? Renderer<Traits>::bytes_needed(capacity) : 0;
  if (needed > most_bytes) return {{{Fault::bad_configuration, Pool::none, 0}}, {}};
  const std::size_t given = needed - std::min(needed, frame.bytes_missing);
  Guarded guarded(given, frame.misaligned, filling);
  Renderer<Traits> renderer(capacity, guarded.memory());
  Outcome first = draw_once(renderer, frame);
  const Outcome second = draw_once(renderer, frame);
  if (!(first == second)) fault = "another picture, or other statuses, the second time";
  const bool sink_failed = first.drawn().fault == Fault::sink_failed;
  const Outcome steps = draw_by_steps(renderer, frame, fault, told);
  if (!sink_failed && !(steps == first)) fault = "another picture, or other statuses, by steps";
  if (!guarded.intact()) fault = "bytes outside the memory were written";
  if (!renderer.status().ok() && first.drawn().ok()) fault = "a renderer that was refused draws";
  if (first.drawn().ok() && first.pixels.size() != std::size_t{capacity.width} * capacity.height)
    fault = "not all of the picture";
  return first;
}

/// What was left out may depend on the band height, where these pools are full or the sink gives up.
bool is_whole(const Outcome& outcome) { return outcome.drawn().ok(); }

struct Drawn {
  std::string name;
  Outcome outcome;
};

template <class Traits>
void draw_in_both(const char* name, const ApiFrame& frame, std::vector<Drawn>& all, std::string& fault,
                  Statuses& told) {
  std::uint8_t filling = 0;
  for (const std::uint16_t lines : {frame.capacity.band_lines, frame.other_lines}) {
    std::string found;
    all.push_back({std::string(name) + ", bands of " + std::to_string(lines),
                   draw_by<Traits>(frame, lines, filling, found, told)});
    if (!found.empty() && fault.empty()) fault = all.back().name + ": " + found;
    filling = 0xff;
  }
}

/// Whole pictures of renderers that draw alike are equal, and so are the statuses of what was added.
std::string difference(const std::vector<Drawn>& all) {
  const auto first = std::find_if(all.begin(), all.end(), [](const Drawn& d) { return is_whole(d.outcome); });
  for (const Drawn& other : all)
    if (is_whole(other.outcome) && !(other.outcome == first->outcome)) return other.name + " is not " + first->name;
  return {};
}

}  // namespace

std::string fault_in(const ApiFrame& frame, Statuses& told) {
  std::string fault;
  std::vector<Drawn> everything, plain;
  draw_in_both<GeneralSeeThroughTraits<Rgb565, Depth24<>>>("zbuffer", frame, everything, fault, told);
  draw_in_both<GeneralSeeThroughTraits<Rgb565, Depth24<>, Spanning>>("span", frame, everything, fault, told);
  draw_in_both<GouraudTraits<Rgb565, Depth16<>, Counted, BoundedZBuffer>>("plain", frame, plain, fault, told);
  for (const auto* all : {&everything, &plain}) {
    if (fault.empty()) fault = difference(*all);
    for (const Drawn& drawn : *all)
      told.insert(told.end(), drawn.outcome.statuses.begin(), drawn.outcome.statuses.end());
  }
  return fault;
}

}  // namespace spanline::fuzz
