#include "scene/scene_textures.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>

#include "base/failure.hpp"
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

TextureImage to_texture(const SceneImage& image, ImageRgba pixels, const TextureOptions& options) {
  try {
    return make_texture(std::move(pixels), options);
  } catch (const Failure& failure) {
    const ImageSource& source = image.colours.exists() ? image.colours : image.opacities;
    throw Failure(source.path.empty() ? source.name + " " + failure.what() : source.path + ": " + failure.what());
  }
}

}  // namespace

SceneTextures load_textures(const Scene& scene, const TextureOptions& options, bool format_wanted) {
  SceneTextures textures;
  std::map<std::tuple<std::uint32_t, AlphaUse, std::uint8_t, Wrap, Wrap>, PartTexture> made;
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
      textures.images.push_back(to_texture(source, std::move(image), own));
      textures.images.back().shape.wrap_s = part.wrap_s;
      textures.images.back().shape.wrap_t = part.wrap_t;
    }
    texture = known;
  }
  return textures;
}

void set_wrap(Scene& scene, Wrap wrap) {
  for (Scene::Part& part : scene.parts) part.wrap_s = part.wrap_t = wrap;
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
  }
}

}  // namespace spanline::sim
