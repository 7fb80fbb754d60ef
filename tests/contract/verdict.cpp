#include "verdict.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "ordered_pixels.hpp"

namespace spanline::contract {
namespace {

std::string place(const Drawing& drawing, std::size_t pixel) {
  const auto width = static_cast<std::size_t>(drawing.width);
  return "column " + std::to_string(pixel % width) + ", row " + std::to_string(pixel / width);
}

/// Where two tables differ: how often, and the first place.
std::string table_difference(const char* what, const std::vector<std::uint32_t>& want,
                             const std::vector<std::uint32_t>& got, const Drawing& drawing) {
  if (want == got) return {};
  if (want.size() != got.size()) return "the pictures have different sizes";
  std::size_t count = 0, first = want.size();
  for (std::size_t i = 0; i < want.size(); ++i)
    if (want[i] != got[i]) {
      first = std::min(first, i);
      ++count;
    }
  std::ostringstream text;
  text << count << ' ' << what << " of " << want.size() << " differ, the first at " << place(drawing, first)
       << ": wanted " << want[first] << ", got " << got[first];
  return text.str();
}

/// Whether a pixel's own polygon holds all pixels around it.
bool is_inside(const Drawing& owners, int x, int y) {
  const std::uint32_t own = owners.pixels[owners.at(x, y)];
  for (int v = std::max(y - 1, 0); v <= std::min(y + 1, owners.height - 1); ++v)
    for (int u = std::max(x - 1, 0); u <= std::min(x + 1, owners.width - 1); ++u)
      if (owners.pixels[owners.at(u, v)] != own) return false;
  return true;
}

std::string wrong_count(const Drawing& drawing) {
  if (!drawing.shades_once) return {};
  const std::uint64_t want = drawing.pixels.size(), got = drawing.counters.named("shaded");
  return got == want ? "" : std::to_string(got) + " pixels shaded of " + std::to_string(want);
}

}  // namespace

std::string difference(const Drawing& want, const Drawing& got) {
  std::string text = table_difference("pixels", want.pixels, got.pixels, want);
  if (text.empty() && !want.depths.empty() && !got.depths.empty())
    text = table_difference("depths", want.depths, got.depths, want);
  return text;
}

std::string far_difference(const Drawing& want, const Drawing& got, const Drawing& owners) {
  if (want.pixels.size() != got.pixels.size()) return "the pictures have different sizes";
  std::size_t count = 0;
  for (int y = 0; y < want.height; ++y)
    for (int x = 0; x < want.width; ++x) {
      const std::size_t pixel = want.at(x, y);
      if (want.pixels[pixel] == got.pixels[pixel]) continue;
      ++count;
      if (is_inside(owners, x, y)) return "a pixel differs that is not at an edge: " + place(want, pixel);
    }
  if (count * 100 <= want.pixels.size()) return {};
  return std::to_string(count) + " pixels of " + std::to_string(want.pixels.size()) + " differ: more than 1 %";
}

std::string disorder(const Drawing& want, const Drawing& got, const Drawing& owners, const std::vector<bool>& ordered) {
  if (want.pixels.size() != got.pixels.size()) return "the pictures have different sizes";
  const bool ids = want.pixels == owners.pixels;
  for (std::size_t i = 0; i < want.pixels.size(); ++i) {
    if (want.pixels[i] == got.pixels[i]) continue;
    if (owners.pixels[i] == 0) return "a pixel of the background is covered: " + place(want, i);
    if (ids && got.pixels[i] == 0) return "a pixel is not covered: " + place(want, i);
    if (ordered[i]) return "a pixel differs that the order of depth decides: " + place(want, i);
  }
  return {};
}

std::string fault_of(Exactness exactness, const Drawing& want, const Drawing& got, const Drawing& owners,
                     const Scene& scene) {
  switch (exactness) {
    case Exactness::exact:
      return difference(want, got);
    case Exactness::near_exact:
      return far_difference(want, got, owners);
    default:
      return disorder(want, got, owners, ordered_pixels(scene));
  }
}

std::string fault_in(const Scene& scene, const Manner& manner, const Drawer& drawer) {
  const Drawing want = drawer.reference(scene, manner);
  const Drawing owners = manner.content == Manner::Content::ids ? want : reference(scene, {});
  for (const AlgorithmEntry& entry : algorithms_for(scene)) {
    const Drawing got = drawer.by(entry, scene, manner);
    std::string fault = got.status.ok() ? fault_of(entry.exactness, want, got, owners, scene)
                                        : std::string(to_string(got.status.fault)) + ": " + to_string(got.status.pool);
    if (fault.empty()) fault = wrong_count(got);
    if (!fault.empty()) return std::string(entry.name) + ": " + fault + "\n" + text_of(scene);
  }
  return {};
}

}  // namespace spanline::contract
