#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/parse.hpp"
#include "image/picture.hpp"
#include "registry/registry.hpp"
#include "scene/core_mesh.hpp"
#include "scene/lighting.hpp"
#include "spanline/frame/renderer.hpp"
#include "spanline/model/cull.hpp"
#include "spanline/visibility/counters.hpp"

namespace spanline::sim {

/// The texture of a part of the scene; stays until the frame is drawn.
struct FrameTexture {
  const Texture* texture = nullptr;
  TexelAlpha alpha = TexelAlpha::cut_out;
};

/// A frame to draw: all that the core needs to know, in its own terms.
struct FrameRequest {
  Size size;
  const AlgorithmEntry* visibility = nullptr;  ///< never null where a frame is drawn
  int band_lines = 16;                         ///< lines a band; the height of the picture for a whole frame
  int depth_bits = 16;
  DepthSense depth_sense = DepthSense::smaller_is_nearer;
  Cull cull = Cull::back;
  bool smooth = false;                       ///< Gouraud
  bool lit = true;                           ///< otherwise colours and textures as they are
  std::span<const FrameTexture> textures{};  ///< by a mesh's part; empty: none
  std::span<const std::uint32_t> objects{};  ///< the object of each triangle, for statistics; empty: there is one
  TextureCoordinates coordinates = TextureCoordinates::mesh;
  TextureFilter filter = TextureFilter::nearest;
  Relief relief;  ///< without heights: none
  Volume volume;
  bool mip_map = false;  ///< a level for each 16 columns of a line
  Fog fog;
  bool dither = false;
  Camera camera;
  SceneLight light;  ///< point lights in the core's world
  Rgb888 background;
  Transparency transparency = Transparency::blend;  ///< of all that is not opaque
  int samples = 1;                                  ///< a pixel: 1, 4, 8 or 16
  bool want_depth = false, want_ids = false, want_statistics = false;
};

/// The obscured triangles, by what is seen at the pixels that they cover: nothing but triangles of their own object,
/// nothing but triangles of other objects, or some of both.
struct ObscuredBy {
  std::uint64_t same_object = 0, other_object = 0, both = 0;
};

/// The lectures' sets of polygons, triangles of all fans: total = outside + back + empty + obscured + visible.
struct PolygonSets {
  std::uint64_t total = 0, outside = 0, back = 0;
  std::uint64_t empty = 0;                         ///< counted if statistics are asked for
  std::optional<std::uint64_t> obscured, visible;  ///< unknown where no ids were kept
  std::optional<ObscuredBy> obscured_by;           ///< the sum of its sets is `obscured`
  std::uint64_t whole = 0;                         ///< polygons of more than three corners that were drawn as one
};

struct FrameStatistics {
  PolygonSets polygons;
  VisibilityCounters visibility;
  std::vector<std::pair<std::string, std::uint64_t>> peak_bytes;  ///< by pool, with "total"
};

/// What came out. Tables that were not asked for are empty.
struct Frame {
  Size size;
  std::vector<std::uint16_t> pixels;  ///< RGB565, row-major
  std::vector<std::uint32_t> depths;  ///< depth integers; background_depth(bits) where nothing was drawn
  std::vector<std::uint32_t> ids;     ///< 1 + triangle number, 0 for the background
  FrameStatistics statistics;
};

/// What `--pick` prints.
struct PickedPixel {
  std::uint32_t id = 0;     ///< 1 + triangle number, 0 for the background
  std::uint32_t depth = 0;  ///< the depth integer; background_depth(bits) for the background
};

/// `polygon 57 depth 31234`.
[[nodiscard]] std::string to_string(const PickedPixel& picked);

/// The depth that stands for the background in pictures of depth, whatever the sense.
[[nodiscard]] constexpr std::uint32_t background_depth(int bits) { return (std::uint32_t{1} << bits) - 1; }

/// Draws frames of one set of meshes; keeps the renderer's memory from frame to frame and lets it grow, so that no pool
/// runs full.
class FrameRenderer {
 public:
  explicit FrameRenderer(std::vector<CoreMesh> meshes);
  /// Bytes of an entry of a pool in the peaks of 16-bit z-buffers' frames.
  [[nodiscard]] static std::size_t entry_size(std::uint32_t Capacity::*pool);

  /// Throws Failure if the core refuses the frame.
  [[nodiscard]] Frame draw(const FrameRequest& request);
  /// Which triangle is seen at a pixel of the frame, and how deep.
  [[nodiscard]] PickedPixel pick(const FrameRequest& request, int x, int y);

 private:
  /// f(drawing) for the drawing that the request asks for.
  template <class Result, class F>
  Result with_drawing(const FrameRequest& request, F f);

  std::vector<CoreMesh> meshes_;
  Capacity capacity_;
  std::vector<std::byte> memory_;
};

/// RGB565 as a picture: channels widened by repeating their upper bits.
[[nodiscard]] Picture to_picture(const std::vector<std::uint16_t>& pixels, Size size);
/// Numbers below 2^24 as a picture, R<<16 | G<<8 | B.
[[nodiscard]] Picture to_picture(const std::vector<std::uint32_t>& numbers, Size size);

}  // namespace spanline::sim
