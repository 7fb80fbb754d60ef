#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "spanline/frame/renderer.hpp"
#include "spanline/model/cull.hpp"
#include "support/screen_triangle.hpp"

namespace spanline::test {

/// A finished picture with its depths as stored.
template <class Traits>
struct Picture {
  using Pixel = typename Traits::Format::Pixel;
  using Depth = typename Traits::Depth;
  int width = 0, height = 0;
  std::vector<Pixel> pixels;
  std::vector<typename Depth::Word> depth;
  std::set<std::uint32_t> covered;  ///< ids that the sink was told of
  friend bool operator==(const Picture& a, const Picture& b) {
    return a.width == b.width && a.height == b.height && a.pixels == b.pixels && a.depth == b.depth;
  }

  [[nodiscard]] std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
  [[nodiscard]] bool drawn(int x, int y) const { return depth[at(x, y)] != Depth::clear; }
  /// The depth integer, smaller is nearer whatever the format's sense.
  [[nodiscard]] std::int64_t depth_integer(int x, int y) const {
    const std::int64_t stored = Depth::integer(depth[at(x, y)]);
    return Depth::smaller ? stored : (std::int64_t{1} << Depth::bits) - 1 - stored;
  }
  [[nodiscard]] std::size_t drawn_count() const {
    return static_cast<std::size_t>(
        std::count_if(depth.begin(), depth.end(), [](auto d) { return d != Depth::clear; }));
  }
};

/// Collects bands into a picture.
template <class Traits>
struct Collector {
  Picture<Traits>& picture;
  template <class Band>
  bool operator()(const Band& band) {
    const auto start = static_cast<std::ptrdiff_t>(picture.at(0, band.y0));
    std::copy(band.pixels.begin(), band.pixels.end(), picture.pixels.begin() + start);
    std::copy(band.depth.begin(), band.depth.end(), picture.depth.begin() + start);
    return true;
  }
  void covered(std::uint32_t id) { picture.covered.insert(id); }
};

/// A renderer with memory of its own.
template <class Traits>
class Studio {
 public:
  using Depth = typename Traits::Depth;
  using PictureType = Picture<Traits>;

  explicit Studio(const Capacity& capacity);

  [[nodiscard]] Renderer<Traits>& renderer() { return renderer_; }
  [[nodiscard]] Statistics statistics() const;
  /// Of the last frame: that of draw(), or the first fault of add().
  [[nodiscard]] Status status() const { return status_; }
  /// What the last add() was told, and what draw() itself was told.
  [[nodiscard]] Status added() const { return added_; }
  [[nodiscard]] Status drawn() const { return drawn_; }

  void begin(const FrameSettings& settings);
  void add(const Mesh& mesh, const Transform& transform, const Material& material);
  void add_screen(std::span<const ScreenVertex> vertices, std::span<const std::uint16_t> colours,
                  const Material& material = {});
  [[nodiscard]] PictureType draw();
  /// A frame of triangles given on screen, none culled.
  [[nodiscard]] PictureType draw_screen(std::span<const Corners> triangles, Cull cull = Cull::none);

  /// A picture of the renderer's size, to be filled.
  [[nodiscard]] PictureType empty_picture() const;
  /// Keeps the first fault of a frame.
  void note(Status status) {
    if (status_.ok()) status_ = status;
  }

 private:
  std::vector<std::byte> memory_;
  Renderer<Traits> renderer_;
  Status status_, added_, drawn_;
};

// Defined outside of the class, so that they are not inline: ready_made_studios.hpp keeps tests from compiling them
// again.

template <class Traits>
Studio<Traits>::Studio(const Capacity& capacity)
    : memory_(Renderer<Traits>::bytes_needed(capacity)), renderer_(capacity, memory_) {
  if (!renderer_.status().ok()) throw std::logic_error("renderer refused its capacity");
}

template <class Traits>
Statistics Studio<Traits>::statistics() const {
  return renderer_.statistics();
}

template <class Traits>
void Studio<Traits>::begin(const FrameSettings& settings) {
  status_ = renderer_.begin(settings);
}

template <class Traits>
void Studio<Traits>::add(const Mesh& mesh, const Transform& transform, const Material& material) {
  added_ = renderer_.add(mesh, transform, material);
  note(added_);
}

template <class Traits>
void Studio<Traits>::add_screen(std::span<const ScreenVertex> vertices, std::span<const std::uint16_t> colours,
                                const Material& material) {
  note(renderer_.add_screen(vertices, colours, material));
}

template <class Traits>
Picture<Traits> Studio<Traits>::draw() {
  PictureType picture = empty_picture();
  drawn_ = renderer_.draw(Collector<Traits>{picture});
  note(drawn_);
  return picture;
}

template <class Traits>
Picture<Traits> Studio<Traits>::draw_screen(std::span<const Corners> triangles, Cull cull) {
  const Capacity& c = renderer_.capacity();
  const auto vertices = vertices_of(triangles, Depth::bits, c.width, c.height);
  std::vector<std::uint16_t> colours(triangles.size());
  for (std::size_t i = 0; i < colours.size(); ++i) colours[i] = static_cast<std::uint16_t>(i * 40503u + 1u);
  FrameSettings settings;
  settings.cull = cull;
  begin(settings);
  add_screen(vertices, colours);
  return draw();
}

template <class Traits>
Picture<Traits> Studio<Traits>::empty_picture() const {
  const Capacity& c = renderer_.capacity();
  PictureType picture{c.width, c.height, {}, {}, {}};
  picture.pixels.resize(std::size_t{c.width} * c.height);
  picture.depth.resize(picture.pixels.size());
  return picture;
}

/// Room for triangles given on screen, in bands of this height (0: one band).
[[nodiscard]] inline Capacity screen_capacity(int width, int height, std::size_t triangles, int band_lines = 0) {
  Capacity c;
  c.width = static_cast<std::uint16_t>(width);
  c.height = static_cast<std::uint16_t>(height);
  c.band_lines = static_cast<std::uint16_t>(band_lines == 0 ? height : std::min(band_lines, height));
  c.colour_bands = 1;
  c.polygons = static_cast<std::uint32_t>(triangles);
  c.active = c.awake = band_lines == 0 ? 0 : static_cast<std::uint32_t>(triangles);
  return c;
}

}  // namespace spanline::test
