#include "render/frame.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/failure.hpp"
#include "render/frame_pass.hpp"
#include "render/obscured_sets.hpp"
#include "scene/core_values.hpp"
#include "spanline/finish/average_samples.hpp"
#include "spanline/frame/ready_made_traits.hpp"

namespace spanline::sim {
namespace {

/// Polygons across a band's edge that there is room for at first; few frames have more.
constexpr std::uint32_t first_active = 4096;

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
  return {{"instances", peaks.instances},
          {"vertices", peaks.vertices},
          {"shades", peaks.shades},
          {"textures", peaks.textures},
          {"polygons", peaks.polygons},
          {"fans", peaks.fans},
          {"active", peaks.active},
          {"awake", peaks.awake},
          {"fragments", peaks.fragments},
          {"layers", peaks.layers},
          {"members", peaks.members},
          {"buckets", peaks.buckets},
          {"colour_bands", peaks.colour_bands},
          {"depth_band", peaks.depth_band},
          {"total", peaks.total()}};
}

std::uint64_t distinct_ids(const std::vector<std::uint32_t>& ids, std::size_t triangles) {
  std::vector<bool> seen(triangles + 1);
  for (const std::uint32_t id : ids) seen[id] = true;
  seen[0] = false;
  return static_cast<std::uint64_t>(std::count(seen.begin(), seen.end(), true));
}

AlgorithmPasses passes_of(const AlgorithmEntry& entry) {
  return with_unit(entry.id, []<AlgorithmId Unit>() { return algorithm_passes<Unit>(); });
}

/// Draws the colour picture and, where asked, the picture of ids.
class FrameDrawing {
 public:
  FrameDrawing(const FrameRequest& request, const std::vector<CoreMesh>& meshes, Capacity& capacity,
               std::vector<std::byte>& memory)
      : request_(request), passes_(passes_of(*request.visibility)), capacity_(capacity), memory_(memory) {
    for (const CoreMesh& mesh : meshes) {
      meshes_.push_back(mesh.view());
      triangles_ += meshes_.back().triangle_count();
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
    draw_colours(frame);
    if (request_.want_ids || request_.want_statistics) draw_ids(frame);
    return frame;
  }

  PickedPixel pick(int x, int y) {
    set_up({}, {});
    return passes_.pick(input(capacity_, settings_), x, y);
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

  /// A pass of this frame, at a capacity and by settings that outlive it.
  [[nodiscard]] PassInput input(Capacity& capacity, const FrameSettings& settings) {
    return {.meshes = meshes_,
            .materials = materials_,
            .settings = settings,
            .triangles = triangles_,
            .depth_bits = request_.depth_bits,
            .depth_sense = request_.depth_sense,
            .capacity = capacity,
            .memory = memory_};
  }

  void draw_colours(Frame& frame) {
    PassInput wanted = input(capacity_, settings_);
    wanted.want_depth = request_.want_depth;
    auto pass = passes_.colours(wanted);
    frame.pixels = std::move(pass.pixels);
    frame.depths = std::move(pass.depths);
    const auto& counted = pass.statistics.polygons;
    FrameStatistics& statistics = frame.statistics;
    statistics.polygons.total = counted.total;
    statistics.polygons.outside = counted.outside;
    statistics.polygons.back = counted.back;
    statistics.polygons.whole = counted.whole;
    statistics.visibility = pass.statistics.visibility;
    statistics.peak_bytes = named_peaks(pass.peaks);
    if (request_.samples > 1) draw_samples(frame.pixels);
  }

  /// The picture again, every pixel the mean of several: 4 of a picture of twice the size, 8 of two such, 16 of one of
  /// four times the size.
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
      const auto pass = passes_.colours(input(capacity_, settings));
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
    PassInput wanted = input(capacity_, settings_);
    // Counted here, where clipped polygons are divided into the triangles of the file, as the picture of ids shows
    // them.
    wanted.want_covered = request_.want_statistics;
    auto pass = passes_.ids(wanted);
    if (request_.want_statistics) {
      const auto covered = static_cast<std::uint64_t>(std::count(pass.covered.begin(), pass.covered.end(), true));
      PolygonSets& polygons = frame.statistics.polygons;
      polygons.empty = polygons.total - polygons.outside - polygons.back - covered;
      polygons.visible = distinct_ids(pass.pixels, triangles_);
      polygons.obscured = covered - *polygons.visible;
      for (const std::uint32_t id : pass.pixels)  // what is left is obscured
        if (id != 0) pass.covered[id - 1] = false;
      polygons.obscured_by = divide_obscured(wanted, pass.pixels, pass.covered, request_.objects);
    }
    if (request_.want_ids) frame.ids = std::move(pass.pixels);
  }

  const FrameRequest& request_;
  AlgorithmPasses passes_;
  std::vector<Mesh> meshes_;
  std::vector<Material> materials_;
  Capacity& capacity_;
  std::vector<std::byte>& memory_;
  FrameSettings settings_;
  std::size_t triangles_ = 0;
};

}  // namespace

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
    case Pool::members:
      return to(capacity.members);
    case Pool::none:
    case Pool::memory:
      break;
  }
  throw Failure("the renderer ran out of memory that it had asked for");
}

std::size_t FrameRenderer::entry_size(std::uint32_t Capacity::*pool) {
  using Drawn = Renderer<GeneralSeeThroughTraits<Rgb565, Depth16<>, Counted>>;
  constexpr std::uint32_t entries = 8;  // a multiple of the arena's alignment whatever the entry's size
  Capacity more;
  more.*pool += entries;
  return (Drawn::bytes_needed(more) - Drawn::bytes_needed(Capacity{})) / entries;
}

FrameRenderer::FrameRenderer(std::vector<CoreMesh> meshes) : meshes_(std::move(meshes)) {
  capacity_.instances = static_cast<std::uint32_t>(meshes_.size());
  for (const CoreMesh& mesh : meshes_) {
    capacity_.vertices += static_cast<std::uint32_t>(mesh.wide_vertices.size());
    const auto triangles = static_cast<std::uint32_t>(mesh.view().triangle_count());
    capacity_.polygons += triangles;
    // An outline takes no more records than its fan, unless it is clipped.
    if (!mesh.corners.empty()) capacity_.fans += triangles;
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
  if (request.band_lines < request.size.height || !request.visibility->full_frame())
    capacity_.active = capacity_.awake = capacity_.members =
        std::max(capacity_.active, std::min(capacity_.polygons, first_active));
  return f(FrameDrawing(request, meshes_, capacity_, memory_));
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
