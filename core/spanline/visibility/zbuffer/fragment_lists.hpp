#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "spanline/memory/arena.hpp"
#include "spanline/raster/link.hpp"
#include "spanline/raster/span.hpp"

namespace spanline {

/// What z-buffers keep of see-through polygons until a band is finished: for each pixel a list of fragments, nearest
/// first (lecture 000, "Transparency": sort per pixel). All come out of one pool.
///
/// Where the pool is full, the farthest of the pixel's fragments, the new one included, is laid over the pixel at once,
/// as if nothing would come behind it or in between any more; the frame's status says how many fragments its fullest
/// band had.
template <class Depth, class Pixel, class Layer>
class FragmentLists {
 public:
  struct Fragment {
    typename Depth::Word depth;  ///< as the depth buffer stores it
    Link next;                   ///< the next one behind it
    Layer layer;
  };

  /// A list a pixel of the band, and a pool of `count` fragments.
  constexpr void take(Arena& arena, std::size_t band_pixels, std::size_t count) {
    heads_ = arena.take<Link>(band_pixels);
    pool_ = arena.take<Fragment>(count);
  }

  void begin_frame() {
    for (Link& head : heads_) head = no_link;
    used_ = 0;
    wanted_ = greatest_ = 0;
  }

  /// A fragment at a pixel of the band, nearer than what is `drawn` there, which is `below`. Fragments come in order of
  /// submission: of equally far ones the earlier is nearer.
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

  /// Lays all fragments of the band's `count` pixels that are not hidden over them, and empties the lists. Fragments
  /// came before what was drawn at the same depth, or they would have been hidden by it.
  void finish_band(const typename Depth::Word* depth, Pixel* pixels, std::size_t count) {
    if (wanted_ > greatest_) greatest_ = wanted_;
    wanted_ = 0;
    if (used_ == 0) return;
    used_ = 0;
    for (std::size_t i = 0; i < count; ++i) {
      if (heads_[i] == no_link) continue;
      Link farther = no_link;  // the list turned round
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

  /// Fragments that the fullest band had, whether there was room for them or not.
  [[nodiscard]] std::uint32_t wanted() const { return greatest_; }
  [[nodiscard]] bool overflowed() const { return greatest_ > pool_.size(); }
  /// Bytes of the fragments that were in use at most.
  [[nodiscard]] std::size_t peak_bytes() const {
    return std::min<std::size_t>(greatest_, pool_.size()) * sizeof(Fragment);
  }

 private:
  /// Frees the farthest fragment of a pixel, which is laid over it unless it was hidden meanwhile; no_link if a
  /// fragment at `depth` is the farthest itself.
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

  std::span<Link> heads_{};
  std::span<Fragment> pool_{};
  Link used_ = 0;
  std::uint32_t wanted_ = 0;    ///< in this band
  std::uint32_t greatest_ = 0;  ///< in any band
};

/// In the place of lists where no shader shows what lies behind.
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
