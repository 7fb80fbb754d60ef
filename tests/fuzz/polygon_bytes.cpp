#include "polygon_bytes.hpp"

#include <algorithm>

#include "brute_force.hpp"
#include "byte_reader.hpp"
#include "sizes.hpp"
#include "verdict.hpp"

namespace spanline::fuzz {
namespace {

using contract::Corner;
using contract::Corners;

constexpr int header_bytes = 5;
enum Opcode : std::uint8_t { wide = 0, narrow = 1, again = 2, shared_edge = 3 };

class Reader : public ByteReader {
 public:
  using ByteReader::ByteReader;

  Corner corner() {
    const int x = half_word(), y = half_word(), low = byte(), middle = byte();
    return contract::corner_near(x, y, low | middle << 8 | byte() << 16);
  }
};

Corners triangle(Reader& reader, const std::vector<Corners>& earlier) {
  const int opcode = reader.byte();
  Corners t{};
  switch (earlier.empty() ? opcode & 1 : opcode & 3) {
    case wide:
      for (Corner& c : t) c = reader.corner();
      return t;
    case narrow:
      for (Corner& c : t) {
        const int x = 16 * (reader.byte() - 64) + (opcode & 4) * 2, y = 16 * (reader.byte() - 64) + (opcode & 8);
        c = contract::corner_near(x, y, std::int64_t{reader.byte()} << 16);
      }
      return t;
    default:
      break;
  }
  t = earlier[static_cast<std::size_t>(reader.byte()) % earlier.size()];
  Corner& c = t[static_cast<std::size_t>(reader.byte() % 3)];
  if ((opcode & 3) == shared_edge) {
    c = reader.corner();
  } else {
    const int dx = reader.signed_byte(), dy = reader.signed_byte();
    c = contract::corner_near(c.x + dx, c.y + dy, c.z + reader.half_word());
  }
  return t;
}

/// With too few records: what is drawn is right, and the status leads on.
std::string starved_fault(const Case& drawn, const AlgorithmEntry& entry, const contract::Drawing& want) {
  contract::Manner manner = drawn.manner;
  const bool layers = manner.content == contract::Manner::Content::layers;
  manner.active = drawn.active;
  if (layers) manner.layers = drawn.active;
  const contract::Drawing got = contract::draw(entry, drawn.scene, manner);
  if (got.shades_once && got.counters.named("shaded") != drawn.scene.pixel_count()) return "not every pixel once";
  if (got.status.ok()) return contract::difference(want, got);
  if (layers && contract::is_of_layers(got.status.pool)) {
    manner.active.reset();
    manner.layers = got.status.wanted;
    const contract::Drawing fed = contract::draw(entry, drawn.scene, manner);
    return fed.status.ok() ? contract::difference(want, fed) : "the size that was named for layers is not enough";
  }
  constexpr Pool pools[] = {Pool::active, Pool::awake, Pool::members};
  if (std::ranges::find(pools, got.status.pool) == std::end(pools)) return "a status that names another pool";
  if (layers) manner.layers.reset();
  if (!layers && contract::garbage_pixels(drawn.scene, got) != 0) return "garbage where the pool ran full";
  manner.active = got.status.wanted;
  const contract::Drawing fed = contract::draw(entry, drawn.scene, manner);
  return fed.status.ok() ? contract::difference(want, fed) : "the size that was named is not enough";
}

}  // namespace

Case decode(std::span<const std::uint8_t> bytes) {
  Reader reader(bytes);
  Case drawn;
  drawn.scene.width = 1 + reader.byte() % most_columns;
  drawn.scene.height = 1 + reader.byte() % most_rows;
  drawn.manner.band_lines = 1 + reader.byte() % drawn.scene.height;
  drawn.active = static_cast<std::uint8_t>(reader.byte());
  const int choice = reader.byte();
  if ((choice & 1) != 0) drawn.manner.sense = DepthSense::larger_is_nearer;
  if ((choice & 2) != 0) drawn.manner.content = contract::Manner::Content::layers;
  std::vector<Corners>& triangles = drawn.scene.triangles;
  while (!reader.empty() && triangles.size() < most_triangles) triangles.push_back(triangle(reader, triangles));
  return drawn;
}

std::vector<std::uint8_t> encode(const contract::Scene& scene, int band_lines, std::uint8_t active, bool layers) {
  std::vector<std::uint8_t> bytes(header_bytes);
  const auto byte = [](int value) { return static_cast<std::uint8_t>(value); };
  bytes[0] = byte(std::min(scene.width, most_columns) - 1);
  bytes[1] = byte(std::min(scene.height, most_rows) - 1);
  bytes[2] = byte(band_lines - 1);
  bytes[3] = active;
  bytes[4] = layers ? 2 : 0;
  for (const Corners& t : scene.triangles) {
    bytes.push_back(wide);
    for (const Corner& c : t)
      for (const int part : {c.x, c.x >> 8, c.y, c.y >> 8, c.z, c.z >> 8, c.z >> 16})
        bytes.push_back(byte(part & 0xff));
  }
  return bytes;
}

std::string fault_in(const Case& drawn) {
  const contract::Scene& scene = drawn.scene;
  const contract::Drawing want = contract::reference(scene, drawn.manner);
  std::string fault;
  constexpr std::size_t brute_work = 30'000;  // pixels × triangles that take no longer than the rest
  const bool ids = drawn.manner.content == contract::Manner::Content::ids;
  if (ids && drawn.manner.sense == DepthSense::smaller_is_nearer &&
      scene.triangles.size() * scene.pixel_count() < brute_work)
    fault = contract::difference(contract::brute_force(scene), want);
  if (!fault.empty()) return "the reference: " + fault + "\n" + contract::text_of(scene);
  for (const AlgorithmEntry& entry : contract::algorithms_for(scene)) {
    if (entry.exactness != Exactness::exact) continue;
    const contract::Drawing got = contract::draw(entry, scene, drawn.manner);
    fault = got.status.ok() ? contract::difference(want, got) : "a pool that was large enough ran full";
    if (fault.empty() && got.shades_once && got.counters.named("shaded") != scene.pixel_count())
      fault = "not every pixel once";
    if (fault.empty() && drawn.active != 0) fault = starved_fault(drawn, entry, want);
    if (!fault.empty()) return std::string(entry.name) + ": " + fault + "\n" + contract::text_of(scene);
  }
  return {};
}

}  // namespace spanline::fuzz
