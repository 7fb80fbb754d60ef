#pragma once
/// @file
/// Lists of see-through fragments at each pixel, after L. Carpenter, "The A-buffer, an Antialiased Hidden Surface
/// Method" (1984), and lecture 000, "Transparency".
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "spanline/memory/arena.hpp"
#include "spanline/raster/link.hpp"
#include "spanline/raster/span.hpp"

namespace spanline {

/// The fragments of see-through polygons, which z-buffers keep until a band is finished: for each pixel a list, nearest
/// first, with all fragments from one pool.
///
/// If the pool is full, the farthest of the pixel's fragments, the new one included, is blended over the pixel at once.
/// The result is wrong if a later polygon lies between that fragment and the pixel. The frame's status says how many
/// fragments the fullest band needs.
template <class Depth, class Pixel, class Layer>
class FragmentLists {
 public:
  struct Fragment {
    typename Depth::Word depth;  ///< as the depth buffer stores it
    Link next;                   ///< the next farther fragment of the pixel
    Layer layer;                 ///< colour and opacity, as the shader gives them
  };

  /// Takes memory for one list for each pixel of the band, and for a pool of `count` fragments.
  constexpr void take(Arena& arena, std::size_t band_pixels, std::size_t count) {
    heads_ = arena.take<Link>(band_pixels);
    pool_ = arena.take<Fragment>(count);
  }

  void begin_frame() {
    for (Link& head : heads_) head = no_link;
    used_ = 0;
    wanted_ = greatest_ = 0;
  }

  /// Adds a fragment at a pixel of the band. It is nearer than the opaque pixel there, whose depth is `drawn` and whose
  /// colour is `below`. Fragments come in order of submission; of equally near ones, the earlier is in front.
  void add(std::size_t pixel, typename Depth::Word depth, const Layer& layer, typename Depth::Word drawn,
           Pixel& below) {
    ++wanted_;
    Link free = used_;
    if (used_ < pool_.size()) {
      ++used_;
    } else {
      free = take_farthest(pixel, depth, drawn, below);
      if (free == no_link) {
        layer.over(below);
        return;
      }
    }
    Link* link = &heads_[pixel];
    while (*link != no_link && !Depth::hides(depth, pool_[*link].depth)) link = &pool_[*link].next;
    pool_[free] = {depth, *link, layer};
    *link = free;
  }

  /// Blends the fragments of the band's `count` pixels over them, except those that an opaque polygon hides, and
  /// empties the lists. A fragment at the same depth as the opaque pixel was submitted earlier, since it passed its
  /// depth test, so it is in front.
  void finish_band(const typename Depth::Word* depth, Pixel* pixels, std::size_t count) {
    if (wanted_ > greatest_) greatest_ = wanted_;
    wanted_ = 0;
    if (used_ == 0) return;
    used_ = 0;
    for (std::size_t i = 0; i < count; ++i) {
      if (heads_[i] == no_link) continue;
      Link farther = no_link;  // the visible part of the list, reversed
      for (Link fragment = heads_[i]; fragment != no_link && !Depth::hides(depth[i], pool_[fragment].depth);) {
        const Link behind = pool_[fragment].next;
        pool_[fragment].next = farther;
        farther = fragment;
        fragment = behind;
      }
      for (; farther != no_link; farther = pool_[farther].next) pool_[farther].layer.over(pixels[i]);
      heads_[i] = no_link;
    }
  }

  /// Number of fragments in the fullest band, including those that found no room.
  [[nodiscard]] std::uint32_t wanted() const { return greatest_; }
  [[nodiscard]] bool overflowed() const { return greatest_ > pool_.size(); }
  /// The most bytes of fragments in use at any time.
  [[nodiscard]] std::size_t peak_bytes() const {
    return std::min<std::size_t>(greatest_, pool_.size()) * sizeof(Fragment);
  }

 private:
  /// Frees the farthest fragment of a pixel, after blending it over the pixel unless an opaque polygon has hidden it
  /// since. Returns no_link if a new fragment at `depth` would be the farthest itself.
  Link take_farthest(std::size_t pixel, typename Depth::Word depth, typename Depth::Word drawn, Pixel& below) {
    Link* link = &heads_[pixel];
    if (*link == no_link) return no_link;
    while (pool_[*link].next != no_link) link = &pool_[*link].next;
    const Link farthest = *link;
    if (!Depth::hides(depth, pool_[farthest].depth)) return no_link;
    if (!Depth::hides(drawn, pool_[farthest].depth)) pool_[farthest].layer.over(below);
    *link = no_link;
    return farthest;
  }

  std::span<Link> heads_{};  ///< nearest fragment of each pixel of the band, or no_link
  std::span<Fragment> pool_{};
  Link used_ = 0;               ///< fragments of the pool that are in use
  std::uint32_t wanted_ = 0;    ///< fragments added in this band
  std::uint32_t greatest_ = 0;  ///< greatest number of fragments added in a band of this frame
};

/// Takes the place of FragmentLists in programs without see-through shaders.
struct NoFragmentLists {
  constexpr void take(Arena&, std::size_t, std::size_t) {}
  void begin_frame() {}
  template <class Word, class Pixel>
  void finish_band(const Word*, Pixel*, std::size_t) {}
  [[nodiscard]] static std::uint32_t wanted() { return 0; }
  [[nodiscard]] static bool overflowed() { return false; }
  [[nodiscard]] static std::size_t peak_bytes() { return 0; }
};

}  // namespace spanline
