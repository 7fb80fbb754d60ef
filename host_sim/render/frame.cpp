#include "render/frame.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/failure.hpp"
#include "registry/visibility_list.hpp"
#include "render/refusal_text.hpp"
#include "scene/core_values.hpp"
#include "spanline/finish/average_samples.hpp"
#include "spanline/frame/pick.hpp"
#include "spanline/frame/ready_made_traits.hpp"

namespace spanline::sim {
namespace {

/// Polygons across a band's edge that there is room for at first; few frames have more.
constexpr std::uint32_t first_active = 4096;

/// Gathers the bands of a frame.
template <class Traits>
struct FrameSink {
  using Pixel = typename Traits::Format::Pixel;
  using Depth = typename Traits::Depth;

  std::vector<Pixel>& pixels;
  std::vector<std::uint32_t>* depths;
  std::vector<bool>* covered_triangles;

  template <class Band>
  bool operator()(const Band& band) {
    pixels.insert(pixels.end(), band.pixels.begin(), band.pixels.end());
    if (depths == nullptr) return true;
    for (const typename Depth::Word word : band.depth)
      depths->push_back(word == Depth::clear ? background_depth(Depth::bits) : Depth::integer(word));
    return true;
  }

  void covered(std::uint32_t triangle) {
    if (covered_triangles != nullptr) (*covered_triangles)[triangle] = true;
  }
};

/// Makes room for what a frame wanted, and a little more so that frames of a turntable rarely ask again.
void grow(Capacity& capacity, const Status& status) {
  const auto to = [&](std::uint32_t& pool) { pool = std::max(status.wanted, pool + pool / 4 + 64); };
  switch (status.pool) {
    case Pool::instances:
      return to(capacity.instances);
    case Pool::vertices:
      return to(capacity.vertices);
    case Pool::shades:
      return to(capacity.shades);
    case Pool::textures:
      return to(capacity.textures);
    case Pool::polygons:
      return to(capacity.polygons);
    case Pool::fans:
      return to(capacity.fans);
    case Pool::active:
      return to(capacity.active);
    case Pool::awake:
      return to(capacity.awake);
    case Pool::fragments:
      return to(capacity.fragments);
    case Pool::layers:
      return to(capacity.layers);
    case Pool::none:
    case Pool::memory:
      break;
  }
  throw Failure("the renderer ran out of memory that it had asked for");
}

/// Draws with one kind of renderer, as often as it takes until every pool is large enough.
template <class Traits>
class Pass {
 public:
  /// `meshes`, `materials`, one a mesh, and the lights of `settings` outlive the pass.
  Pass(const std::vector<Mesh>& meshes, const FrameSettings& settings, const std::vector<Material>& materials)
      : meshes_(meshes), settings_(settings), materials_(materials) {}

  std::vector<typename Traits::Format::Pixel> pixels;
  std::vector<std::uint32_t> depths;
  std::vector<bool> covered;
  Statistics statistics{};
  PoolPeaks peaks{};
  bool want_depth = false, want_covered = false;

  /// The whole frame into the tables above.
  void run(Capacity& capacity, std::vector<std::byte>& memory, std::size_t triangles) {
    run(capacity, memory, [this, triangles](Renderer<Traits>& renderer) {
      pixels.clear();
      depths.clear();
      covered.assign(want_covered ? triangles : 0, false);
      return renderer.draw(
          FrameSink<Traits>{pixels, want_depth ? &depths : nullptr, want_covered ? &covered : nullptr});
    });
  }

  /// Submits the frame and finishes it by `finish(renderer)`, as often as it takes.
  template <class Finish>
  void run(Capacity& capacity, std::vector<std::byte>& memory, Finish finish) {
    for (;;) {
      const Status status = attempt(capacity, memory, finish);
      if (status.ok()) return;
      if (status.fault != Fault::pool_full) throw Failure(refusal_text(status));
      grow(capacity, status);
    }
  }

 private:
  template <class Finish>
  Status attempt(const Capacity& capacity, std::vector<std::byte>& memory, Finish finish) {
    const std::size_t bytes = Renderer<Traits>::bytes_needed(capacity);
    if (memory.size() < bytes) memory.resize(bytes);
    Renderer<Traits> renderer(capacity, std::span(memory).first(bytes));
    if (const Status status = renderer.status(); !status.ok()) return status;
    if (const Status status = renderer.begin(settings_); !status.ok()) return status;
    for (std::size_t i = 0; i < meshes_.size(); ++i)
      if (const Status status = renderer.add(meshes_[i], Transform{}, materials_[i]); !status.ok()) return status;
    if (const Status status = finish(renderer); !status.ok()) return status;
    statistics = renderer.statistics();
    peaks = renderer.peaks();
    return {};
  }

  const std::vector<Mesh>& meshes_;
  FrameSettings settings_;
  const std::vector<Material>& materials_;
};

std::vector<DirectionalLight> to_core_lights(const SceneLight& light) {
  std::vector<DirectionalLight> lights;
  for (const Vector3 towards : light.towards)
    lights.push_back({to_direction(towards), to_fixed<Fixed<16>>(light.intensity)});
  return lights;
}

std::vector<PointLight> to_core_points(const SceneLight& light) {
  std::vector<PointLight> points;
  for (const ScenePointLight& point : light.points) {
    const Vector3 at = point.position;
    points.push_back({{to_fixed<Q16_16>(at.x), to_fixed<Q16_16>(at.y), to_fixed<Q16_16>(at.z)},
                      to_fixed<Fixed<16>>(light.intensity),
                      to_fixed<Q16_16>(point.range)});
  }
  return points;
}

std::vector<std::pair<std::string, std::uint64_t>> named_peaks(const PoolPeaks& peaks) {
  return {{"instances", peaks.instances},   {"vertices", peaks.vertices}, {"shades", peaks.shades},
          {"textures", peaks.textures},     {"polygons", peaks.polygons}, {"fans", peaks.fans},
          {"active", peaks.active},         {"awake", peaks.awake},       {"fragments", peaks.fragments},
          {"layers", peaks.layers},         {"buckets", peaks.buckets},   {"colour_bands", peaks.colour_bands},
          {"depth_band", peaks.depth_band}, {"total", peaks.total()}};
}

std::uint64_t distinct_ids(const std::vector<std::uint32_t>& ids, std::size_t triangles) {
  std::vector<bool> seen(triangles + 1);
  for (const std::uint32_t id : ids) seen[id] = true;
  seen[0] = false;
  return static_cast<std::uint64_t>(std::count(seen.begin(), seen.end(), true));
}

/// What colours are drawn with: one list of shaders for everything that a model may have.
template <class Depth, class Visibility>
using Colours = GeneralSeeThroughTraits<Rgb565, Depth, Counted, Visibility>;

/// Draws the colour picture and, where asked, the picture of ids, with one format of depth.
template <class Depth, class Visibility>
class FrameDrawing {
 public:
  FrameDrawing(const FrameRequest& request, const std::vector<CoreMesh>& meshes, Capacity& capacity,
               std::vector<std::byte>& memory)
      : request_(request), capacity_(capacity), memory_(memory) {
    for (const CoreMesh& mesh : meshes) {
      triangles_ += mesh.indices.size() / 3;
      meshes_.push_back(mesh.view());
    }
    refuse_mixtures(meshes);
    const CoreMesh& first = meshes.front();
    // Without normals every vertex is fully lit: only colours of vertices call for interpolation then.
    const bool smooth = request.smooth && !(first.vertex_normals.empty() && first.vertex_colours.empty());
    Material material{.shading = smooth ? ShadingMode::gouraud : ShadingMode::flat};
    material.lit = request.lit;
    material.texturing.coordinates = request.coordinates;
    material.texturing.filter = request.filter;
    if (request.mip_map) material.texturing.mip_mapping = MipMapping::span;
    material.transparency = request.transparency;
    material.relief = request.relief;
    material.volume = request.volume;
    for (const CoreMesh& mesh : meshes) {
      const FrameTexture texture = texture_of(mesh);
      material.colour = mesh.colour;
      material.opacity = mesh.opacity;
      material.specular = mesh.highlights.specular;
      material.shininess = mesh.highlights.shininess;
      material.texturing.texture = texture.texture;
      material.texturing.alpha = texture.alpha;
      materials_.push_back(material);
    }
  }

  Frame draw() {
    const std::vector<DirectionalLight> lights = to_core_lights(request_.light);
    const std::vector<PointLight> points = to_core_points(request_.light);
    set_up(lights, points);
    Frame frame;
    frame.size = request_.size;
    draw_colours<Colours<Depth, Visibility>>(frame);
    if (request_.want_ids || request_.want_statistics) draw_ids(frame);
    return frame;
  }

  PickedPixel pick(int x, int y) {
    set_up({}, {});
    Pass<IdTraits<Depth, Counted, Visibility>> pass(meshes_, settings_, materials_);
    Picked<Depth> picked;
    pass.run(capacity_, memory_, [&](auto& renderer) { return spanline::pick(renderer, x, y, picked); });
    return {picked.id, picked.id == 0 ? background_depth(Depth::bits) : picked.depth};
  }

 private:
  /// What the core has no shader for, by the names of its options.
  void refuse_mixtures(const std::vector<CoreMesh>& meshes) const {
    const auto any = [&](auto holds) { return std::any_of(meshes.begin(), meshes.end(), holds); };
    const bool pixel_by_pixel = request_.relief.heights != nullptr || request_.volume.source != SolidSource::none;
    if (pixel_by_pixel && any([this](const CoreMesh& mesh) {
          const Texture* texture = texture_of(mesh).texture;
          return !mesh.vertex_opacities.empty() || (texture != nullptr && texture->has_alpha());
        }))
      throw NotAvailable("--bump, --emboss and --solid on vertices or textures with opacities");
    if (any([this](const CoreMesh& mesh) {
          const bool local = mesh.highlights.shines() || !request_.light.points.empty();
          return local && !mesh.vertex_opacities.empty();
        }))
      throw NotAvailable("--specular and --point-light on vertices with opacities");
  }
  [[nodiscard]] FrameTexture texture_of(const CoreMesh& mesh) const {
    return mesh.part < request_.textures.size() ? request_.textures[mesh.part] : FrameTexture{};
  }

  void set_up(const std::vector<DirectionalLight>& lights, const std::vector<PointLight>& points) {
    settings_.camera = request_.camera;
    settings_.lighting = {to_fixed<Fixed<16>>(request_.light.ambient), lights, points};
    settings_.background = request_.background;
    settings_.cull = request_.cull;
    settings_.fog = request_.fog;
    settings_.dither = request_.dither;
  }

  template <class Traits>
  void draw_colours(Frame& frame) {
    Pass<Traits> pass(meshes_, settings_, materials_);
    pass.want_depth = request_.want_depth;
    pass.want_covered = request_.want_statistics;
    pass.run(capacity_, memory_, triangles_);
    frame.pixels = std::move(pass.pixels);
    frame.depths = std::move(pass.depths);
    const auto& counted = pass.statistics.polygons;
    covered_ = static_cast<std::uint64_t>(std::count(pass.covered.begin(), pass.covered.end(), true));
    FrameStatistics& statistics = frame.statistics;
    statistics.polygons.total = counted.total;
    statistics.polygons.outside = counted.outside;
    statistics.polygons.back = counted.back;
    if (request_.want_statistics) statistics.polygons.empty = counted.total - counted.outside - counted.back - covered_;
    statistics.visibility = pass.statistics.visibility;
    statistics.peak_bytes = named_peaks(pass.peaks);
    if (request_.samples > 1) draw_samples<Traits>(frame.pixels);
  }

  /// The picture again, every pixel the mean of several: 4 of a picture of twice the size, 8 of two such, 16 of one of
  /// four times the size.
  template <class Traits>
  void draw_samples(std::vector<std::uint16_t>& pixels) {
    const unsigned factor = request_.samples == 16 ? 4 : 2;
    const int passes = request_.samples == 8 ? 2 : 1;
    const Capacity plain = capacity_;
    capacity_.width = static_cast<std::uint16_t>(capacity_.width * factor);
    capacity_.height = static_cast<std::uint16_t>(capacity_.height * factor);
    capacity_.band_lines = static_cast<std::uint16_t>(
        plain.band_lines == plain.height ? capacity_.height
                                         : std::min<unsigned>(plain.band_lines * factor, capacity_.height));
    FrameSettings settings = settings_;
    const std::int64_t focal = settings.camera.focal.raw() * static_cast<std::int64_t>(factor);
    if (focal > std::numeric_limits<std::int32_t>::max())
      throw UsageError("--samples: the view is too narrow for so many a pixel");
    settings.camera.focal = Q16_16::from_raw(static_cast<std::int32_t>(focal));
    std::vector<std::uint32_t> sums(pixels.size());
    for (int number = 0; number < passes; ++number) {
      settings.stipple_seed = static_cast<std::uint8_t>(number);
      Pass<Traits> pass(meshes_, settings, materials_);
      pass.run(capacity_, memory_, triangles_);
      const std::size_t stride = capacity_.width;
      for (std::size_t i = 0; i < sums.size(); ++i)
        sums[i] +=
            sample_sum<Rgb565>(pass.pixels.data() + i / plain.width * factor * stride, stride, i % plain.width, factor);
    }
    const unsigned log2_samples = request_.samples == 4 ? 2 : request_.samples == 8 ? 3 : 4;
    for (std::size_t i = 0; i < sums.size(); ++i) pixels[i] = sample_mean(sums[i], log2_samples);
    capacity_.width = plain.width;
    capacity_.height = plain.height;
    capacity_.band_lines = plain.band_lines;
  }

  void draw_ids(Frame& frame) {
    if (triangles_ >= (1u << 24)) throw Failure("pictures of ids count to 16777215, and the model has more triangles");
    Pass<IdTraits<Depth, Visibility>> pass(meshes_, settings_, materials_);
    pass.run(capacity_, memory_, triangles_);
    const std::uint64_t visible = distinct_ids(pass.pixels, triangles_);
    frame.statistics.polygons.visible = visible;
    frame.statistics.polygons.obscured = covered_ - visible;
    if (request_.want_ids) frame.ids = std::move(pass.pixels);
  }

  const FrameRequest& request_;
  std::vector<Mesh> meshes_;
  std::vector<Material> materials_;
  Capacity& capacity_;
  std::vector<std::byte>& memory_;
  FrameSettings settings_;
  std::size_t triangles_ = 0;
  std::uint64_t covered_ = 0;
};

}  // namespace

std::size_t FrameRenderer::entry_size(std::uint32_t Capacity::*pool) {
  using Drawn = Renderer<Colours<Depth16<>, ZBuffer>>;
  constexpr std::uint32_t entries = 8;  // a multiple of the arena's alignment whatever the entry's size
  Capacity more;
  more.*pool += entries;
  return (Drawn::bytes_needed(more) - Drawn::bytes_needed(Capacity{})) / entries;
}

FrameRenderer::FrameRenderer(std::vector<CoreMesh> meshes) : meshes_(std::move(meshes)) {
  capacity_.instances = static_cast<std::uint32_t>(meshes_.size());
  for (const CoreMesh& mesh : meshes_) {
    capacity_.vertices += static_cast<std::uint32_t>(mesh.wide_vertices.size());
    capacity_.polygons += static_cast<std::uint32_t>(mesh.indices.size() / 3);
  }
}

Frame FrameRenderer::draw(const FrameRequest& request) {
  return with_drawing<Frame>(request, [](auto drawing) { return drawing.draw(); });
}

PickedPixel FrameRenderer::pick(const FrameRequest& request, int x, int y) {
  return with_drawing<PickedPixel>(request, [x, y](auto drawing) { return drawing.pick(x, y); });
}

template <class Result, class F>
Result FrameRenderer::with_drawing(const FrameRequest& request, F f) {
  capacity_.width = static_cast<std::uint16_t>(request.size.width);
  capacity_.height = static_cast<std::uint16_t>(request.size.height);
  capacity_.band_lines = static_cast<std::uint16_t>(request.band_lines);
  capacity_.colour_bands = 1;
  if (!request.textures.empty() || request.relief.heights != nullptr || request.volume.source != SolidSource::none)
    capacity_.textures = std::max(capacity_.textures, capacity_.vertices);
  const bool with_opacities =
      std::any_of(meshes_.begin(), meshes_.end(), [](const CoreMesh& mesh) { return !mesh.vertex_opacities.empty(); });
  if (request.smooth || with_opacities) capacity_.shades = std::max(capacity_.shades, capacity_.vertices);
  if (request.band_lines < request.size.height || !request.visibility->full_frame)
    capacity_.active = capacity_.awake = std::max(capacity_.active, std::min(capacity_.polygons, first_active));
  return with_visibility(*request.visibility, [&]<class Visibility>() -> Result {
    const auto with = [&]<class Depth>(Depth*) {
      return f(FrameDrawing<Depth, Visibility>(request, meshes_, capacity_, memory_));
    };
    constexpr auto smaller = DepthSense::smaller_is_nearer, larger = DepthSense::larger_is_nearer;
    const bool smaller_wanted = request.depth_sense == smaller;
    if (request.depth_bits == 16)
      return smaller_wanted ? with(static_cast<Depth16<smaller>*>(nullptr))
                            : with(static_cast<Depth16<larger>*>(nullptr));
    return smaller_wanted ? with(static_cast<Depth24<smaller>*>(nullptr))
                          : with(static_cast<Depth24<larger>*>(nullptr));
  });
}

std::string to_string(const PickedPixel& picked) {
  return "polygon " + std::to_string(picked.id) + " depth " + std::to_string(picked.depth);
}

Picture to_picture(const std::vector<std::uint16_t>& pixels, Size size) {
  Picture picture(size.width, size.height);
  std::transform(pixels.begin(), pixels.end(), picture.pixels.begin(), widened);
  return picture;
}

Picture to_picture(const std::vector<std::uint32_t>& numbers, Size size) {
  Picture picture(size.width, size.height);
  std::transform(numbers.begin(), numbers.end(), picture.pixels.begin(), number_pixel);
  return picture;
}

}  // namespace spanline::sim
