#pragma once
#include <cstddef>
#include <cstdint>

#include "spanline/cpu/block_run.hpp"
#include "spanline/cpu/texel_table.hpp"
#include "spanline/cpu/texture_steps.hpp"
#include "spanline/raster/depth_format.hpp"
#include "twin_case.hpp"

/// Blocks of a texture against the depth buffer: whole ones, the left or the right part of one, and its middle.
namespace twins {

using namespace spanline;

/// A surface whose blocks are any.
struct AnyTexels {
  struct Source {
    static constexpr bool constant = false;
    TextureSteps coordinates;
    TexelTable table;
    [[nodiscard]] std::uint16_t get() const {
      return table.words[((coordinates.u >> 16) & table.mask_u) + ((coordinates.v >> 12) & table.mask_v)];
    }
    void forward() { coordinates.forward(); }
    void back() { coordinates.back(); }
    void next_piece() { coordinates.next_piece(); }
    void next_piece(const TextureBlock& block) { coordinates.next_piece(block); }
    void restart(const TextureBlock& block) { coordinates.restart(block); }
    void restart(const TextureBlock& block, std::uint32_t columns) {
      coordinates.restart(block);
      coordinates.skip(columns, block);
    }
    void next_block() {}
  };
  /// The blocks of a run, so many at a time.
  struct Certain {
    const AnyTexels& surface;
    std::uint32_t left, done = 0;
    [[nodiscard]] bool certain() const { return true; }
    [[nodiscard]] std::uint32_t into_block() const { return surface.into; }
    [[nodiscard]] const TextureBlock* blocks() const { return surface.all + done; }
    [[nodiscard]] std::uint32_t count() const { return left < surface.at_a_time ? left : surface.at_a_time; }
    bool next() {
      done += count();
      left -= count();
      return left != 0;
    }
  };
  /// For the concept alone: every block is certain.
  struct Blocks {
    [[nodiscard]] std::uint32_t rest() const { return 1; }
    [[nodiscard]] std::uint32_t rest_of_block() const { return 1; }
    [[nodiscard]] Source source() const { return {}; }
    void next() {}
  };

  const TextureBlock* all;
  std::uint32_t into, at_a_time;
  TexelTable table;

  [[nodiscard]] TexelTable texel_table() const { return table; }
  [[nodiscard]] Certain certain(std::int32_t, std::uint32_t count) const { return {*this, (into + count + 15) / 16}; }
  [[nodiscard]] Blocks blocks(std::int32_t) const { return {}; }
  [[nodiscard]] Source source(std::int32_t) const {
    Source source;
    source.table = table;
    return source;
  }
  void fill_blocks(std::int32_t column, const TextureBlock* blocks, std::uint32_t count, std::uint16_t* pixels) const {
    Source at = source(column);
    for (const TextureBlock* const end = blocks + count; blocks != end; ++blocks, pixels += 16) {
      at.restart(*blocks);
      for (std::size_t i = 0; i < 16; ++i) {
        pixels[i] = at.get();
        at.forward();
        if (i % 4 == 3) at.next_piece(*blocks);
      }
    }
  }
};
static_assert(TableSurface<AnyTexels>);

enum class Part : std::uint8_t { whole, left, right, middle, any };

/// Where a run begins in its first block, and its length.
struct RunExtent {
  std::uint32_t into, count;
};
inline RunExtent random_extent(Random& random, Part part) {
  const std::uint32_t blocks = 1 + random.below(7);
  switch (part) {
    case Part::whole:
      return {0, 16 * blocks};
    case Part::left:
      return {0, 16 * (blocks - 1) + 1 + random.below(15)};
    case Part::right: {
      const std::uint32_t into = 1 + random.below(15);
      return {into, 16 * blocks - into};
    }
    case Part::middle: {
      const std::uint32_t into = 1 + random.below(14);
      return {into, 1 + random.below(15 - into)};
    }
    case Part::any:
      break;
  }
  return {random.below(16), 1 + random.below(112)};
}

inline bool texel_blocks_alike(Random& random, Part part) {
  static std::uint16_t texels[512];
  static TextureBlock blocks[8];
  static Buffers<160> buffers;
  for (std::uint16_t& texel : texels) texel = static_cast<std::uint16_t>(random());
  for (TextureBlock& block : blocks) block = {random(), random(), random(), random(), random(), random()};
  const RunExtent extent = random_extent(random, part);
  const std::uint32_t start = 8 + random.below(4), z = random(), dz = random_step(random);
  const AnyTexels surface{blocks, extent.into, 1 + random.below(8), {texels, 31, 15 * 32}};
  buffers.fill(random, 160, z);
  const auto as_it_is = [](const auto& source) { return source; };
  BlockRun<Depth16<>, std::uint16_t>::run(buffers.fast.depth + start, buffers.fast.pixels + start, extent.count, z, dz,
                                          surface, 0, as_it_is);
  BlockRun<Depth16<>, std::uint16_t, Form::portable>::run(
      buffers.portable.depth + start, buffers.portable.pixels + start, extent.count, z, dz, surface, 0, as_it_is);
  return buffers.alike(160);
}

}  // namespace twins
