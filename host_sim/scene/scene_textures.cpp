#include "scene/scene_textures.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>

#include "base/failure.hpp"
#include "image/mirrored.hpp"
#include "scene/composed_image.hpp"

namespace spanline::sim {
namespace {

AlphaUse use_of(const ImageRgba& image) {
  const auto any = [&](auto holds) {
    return std::any_of(image.pixels.begin(), image.pixels.end(), [&](const Rgba8888& p) { return holds(p.alpha); });
  };
  if (any([](int alpha) { return alpha != 0 && alpha != 255; })) return AlphaUse::blend;
  return any([](int alpha) { return alpha == 0; }) ? AlphaUse::cut_out : AlphaUse::opaque;
}

void cut(ImageRgba& image, std::uint8_t cut_off) {
  for (Rgba8888& pixel : image.pixels) pixel.alpha = pixel.alpha >= cut_off ? 255 : 0;
}

TexelFormat format_for(AlphaUse use, TexelFormat opaque) {
  if (use == AlphaUse::cut_out) return TexelFormat::rgb565_cutout;
  return use == AlphaUse::blend ? TexelFormat::argb4444 : opaque;
}

Wrap core_wrap(PartWrap wrap) { return wrap == PartWrap::clamp ? Wrap::clamp : Wrap::repeat; }

bool is_mirrored(const Scene::Part& part) {
  return part.image != Scene::Part::no_image && (part.wrap_s == PartWrap::mirror || part.wrap_t == PartWrap::mirror);
}

/// Image and mirror image in one, where the part's texture repeats so.
ImageRgba unfolded(ImageRgba image, const Scene::Part& part, bool resize) {
  if (!is_mirrored(part)) return image;
  image = with_mirror_image(with_allowed_size(std::move(image), resize), part.wrap_s == PartWrap::mirror,
                            part.wrap_t == PartWrap::mirror);
  try {
    return with_allowed_size(std::move(image), resize);
  } catch (const Failure& failure) {
    throw Failure(std::string("with its mirror image ") + failure.what());
  }
}

TextureImage to_texture(const SceneImage& image, ImageRgba pixels, const Scene::Part& part,
                        const TextureOptions& options) {
  try {
    return make_texture(unfolded(std::move(pixels), part, options.resize), options);
  } catch (const Failure& failure) {
    const ImageSource& source = image.colours.exists() ? image.colours : image.opacities;
    throw Failure(source.path.empty() ? source.name + " " + failure.what() : source.path + ": " + failure.what());
  }
}

}  // namespace

SceneTextures load_textures(const Scene& scene, const TextureOptions& options, bool format_wanted) {
  SceneTextures textures;
  std::map<std::tuple<std::uint32_t, AlphaUse, std::uint8_t, PartWrap, PartWrap>, PartTexture> made;
  for (const Scene::Part& part : scene.parts) {
    PartTexture& texture = textures.of_part.emplace_back();
    if (part.image == Scene::Part::no_image) continue;
    PartTexture& known = made[{part.image, part.alpha, part.cut_off, part.wrap_s, part.wrap_t}];
    if (known.image == PartTexture::none) {
      const SceneImage& source = scene.images[part.image];
      ImageRgba image = composed(source);
      const AlphaUse use = part.alpha == AlphaUse::by_image ? use_of(image) : part.alpha;
      if (use == AlphaUse::cut_out) cut(image, part.cut_off);
      TextureOptions own = options;
      if (!format_wanted) own.format = format_for(use, options.format);
      known = {textures.images.size(), use == AlphaUse::blend ? TexelAlpha::blend : TexelAlpha::cut_out};
      textures.images.push_back(to_texture(source, std::move(image), part, own));
      textures.images.back().shape.wrap_s = core_wrap(part.wrap_s);
      textures.images.back().shape.wrap_t = core_wrap(part.wrap_t);
    }
    texture = known;
  }
  return textures;
}

bool has_mirrored_textures(const Scene& scene) {
  return !scene.texture_points.empty() && std::any_of(scene.parts.begin(), scene.parts.end(), is_mirrored);
}

void halve_mirrored_coordinates(Scene& scene) {
  if (!has_mirrored_textures(scene)) return;
  std::vector<bool> halved(scene.positions.size());
  for (std::size_t number = 0; number < scene.parts.size(); ++number) {
    const Scene::Part& part = scene.parts[number];
    if (!is_mirrored(part)) continue;
    const std::size_t end = number + 1 < scene.parts.size() ? scene.parts[number + 1].first : scene.triangles.size();
    for (std::size_t i = part.first; i < end; ++i)
      for (const std::uint32_t vertex : scene.triangles[i]) {
        if (halved[vertex]) continue;  // vertices belong to one part, but to several of its triangles
        halved[vertex] = true;
        TexturePoint& point = scene.texture_points[vertex];
        if (part.wrap_s == PartWrap::mirror) point.s /= 2;
        if (part.wrap_t == PartWrap::mirror) point.t /= 2;
      }
  }
}

void set_wrap(Scene& scene, Wrap wrap) {
  for (Scene::Part& part : scene.parts)
    part.wrap_s = part.wrap_t = wrap == Wrap::clamp ? PartWrap::clamp : PartWrap::repeat;
}

void use_texture(Scene& scene, const std::string& path) {
  if (scene.parts.empty()) scene.parts.emplace_back();
  if (!is_textured(scene)) scene.vertex_colours.clear();
  const auto number = static_cast<std::uint32_t>(scene.images.size());
  scene.images.push_back({.colours = {path, path, {}}, .opacities = {}});
  for (Scene::Part& part : scene.parts) {
    if (part.image != Scene::Part::no_image) continue;
    part.image = number;
    part.colour = {255, 255, 255};
    part.alpha = AlphaUse::by_image;
  }
}

void use_environment(Scene& scene, const std::string& path) {
  if (scene.parts.empty()) scene.parts.emplace_back();
  scene.vertex_colours.clear();
  scene.polygon_colours.clear();
  scene.texture_points.clear();
  scene.colour = {255, 255, 255};
  scene.images = {{.colours = {path, path, {}}, .opacities = {}}};
  for (Scene::Part& part : scene.parts) {
    part.image = 0;
    part.colour = {255, 255, 255};
    part.alpha = AlphaUse::opaque;
    part.wrap_s = part.wrap_t = PartWrap::repeat;
  }
}

}  // namespace spanline::sim
