#include "import/material_texture.hpp"

#include <assimp/material.h>
#include <assimp/scene.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>

namespace spanline::sim {
namespace {

PartWrap to_wrap(aiTextureMapMode mode) {
  if (mode == aiTextureMapMode_Mirror) return PartWrap::mirror;
  return mode == aiTextureMapMode_Clamp ? PartWrap::clamp : PartWrap::repeat;
}

/// A URI's %20 and the like.
std::string percent_decoded(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    unsigned value = 0;
    if (text[i] == '%' && i + 2 < text.size() &&
        std::from_chars(text.data() + i + 1, text.data() + i + 3, value, 16).ptr == text.data() + i + 3) {
      result += static_cast<char>(value);
      i += 2;
    } else {
      result += text[i];
    }
  }
  return result;
}

/// Names count from the model's folder; some were written on machines whose folders part by backslashes.
std::string image_path(std::string name, const std::string& model) {
  std::replace(name.begin(), name.end(), '\\', '/');
  const std::filesystem::path folder = std::filesystem::path(model).parent_path();
  std::error_code error;
  if (const auto plain = folder / name; std::filesystem::exists(plain, error)) return plain.string();
  return (folder / percent_decoded(name)).string();
}

ImageSource to_source(const aiScene& file, const aiString& name, const std::string& model) {
  const aiTexture* embedded = file.GetEmbeddedTexture(name.C_Str());
  if (embedded == nullptr) {
    const std::string path = image_path(name.C_Str(), model);
    return {path, path, {}};
  }
  ImageSource image{model + ": the texture inside it", {}, {}};
  // A compressed image's size stands in the width; others have no bytes of a file, and are refused as empty ones.
  if (embedded->mHeight == 0) {
    const auto* bytes = reinterpret_cast<const std::byte*>(embedded->pcData);
    image.bytes.assign(bytes, bytes + embedded->mWidth);
  }
  return image;
}

/// Assimp states a rotation about the texture's middle, in coordinates whose t counts upwards, with a translation to
/// suit; both are taken back here, in the terms of its importer of glTF, which is the only one that states any.
TextureTransform transform_of(const aiMaterial& material, aiTextureType type) {
  aiUVTransform stated;
  if (material.Get(AI_MATKEY_UVTRANSFORM(type, 0), stated) != aiReturn_SUCCESS) return {};
  TextureTransform transform;
  transform.rotation = -static_cast<double>(stated.mRotation);
  transform.scale_s = static_cast<double>(stated.mScaling.x);
  transform.scale_t = static_cast<double>(stated.mScaling.y);
  const double cosine = std::cos(transform.rotation), sine = std::sin(transform.rotation);
  transform.offset_s = static_cast<double>(stated.mTranslation.x) - 0.5 * transform.scale_s * (1 - cosine + sine);
  transform.offset_t = 1 - transform.scale_t + 0.5 * transform.scale_t * (cosine + sine - 1) -
                       static_cast<double>(stated.mTranslation.y);
  return transform;
}

/// Reads the first texture of a kind, and how it lies on the surface, unless there is none.
bool read_texture(const aiScene& file, const aiMaterial& material, aiTextureType type, const std::string& model,
                  ImageSource& source, MaterialTexture& texture) {
  aiString name;
  unsigned set = 0;
  aiTextureMapMode modes[3] = {aiTextureMapMode_Wrap, aiTextureMapMode_Wrap, aiTextureMapMode_Wrap};
  if (material.GetTexture(type, 0, &name, nullptr, &set, nullptr, nullptr, modes) != aiReturn_SUCCESS ||
      name.length == 0)
    return false;
  source = to_source(file, name, model);
  texture.points = set;
  texture.transform = transform_of(material, type);
  texture.wrap_s = to_wrap(modes[0]);
  texture.wrap_t = to_wrap(modes[1]);
  return true;
}

}  // namespace

TexturePoint TextureTransform::operator()(TexturePoint point) const {
  const double cosine = std::cos(rotation), sine = std::sin(rotation);
  const double s = point.s * scale_s, t = point.t * scale_t;
  return {offset_s + s * cosine + t * sine, offset_t - s * sine + t * cosine};
}

MaterialTexture texture_of(const aiScene& file, const aiMaterial& material, const std::string& path) {
  MaterialTexture texture;
  SceneImage image;
  const auto read = [&](aiTextureType type, ImageSource& source) {
    return read_texture(file, material, type, path, source, texture);
  };
  // What the colours say of the way they lie stands, where both say something.
  const bool opacities = read(aiTextureType_OPACITY, image.opacities);
  const bool colours = read(aiTextureType_BASE_COLOR, image.colours) || read(aiTextureType_DIFFUSE, image.colours);
  if (colours || opacities) texture.image = std::move(image);
  return texture;
}

}  // namespace spanline::sim
