#include "import/materials.hpp"

#include <assimp/ObjMaterial.h>
#include <assimp/material.h>
#include <assimp/scene.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <string_view>

namespace spanline::sim {
namespace {

/// Importers make a material up where a file has none: without a name or with the default one, white or 0.6 grey.
bool made_up(const aiMaterial& material, const aiColor4D& colour) {
  aiString name;
  const bool named = material.Get(AI_MATKEY_NAME, name) == aiReturn_SUCCESS;
  if (named && std::string_view(name.C_Str()) != AI_DEFAULT_MATERIAL_NAME) return false;
  return colour.r == colour.g && colour.g == colour.b && (colour.r == ai_real(1) || colour.r == ai_real(0.6));
}

std::optional<ColourFactor> diffuse_colour(const aiMaterial& material) {
  aiColor4D colour;
  if (material.Get(AI_MATKEY_COLOR_DIFFUSE, colour) != aiReturn_SUCCESS || made_up(material, colour))
    return std::nullopt;
  return ColourFactor{static_cast<double>(colour.r), static_cast<double>(colour.g), static_cast<double>(colour.b)};
}

/// Highlights of MTL, where its illumination model has them (Wavefront, "MTL material format": 2 to 9). Only there is
/// an exponent of this kind: glTF's roughness is none. Without one the importer says 0, which is no highlight.
Highlights highlights_of(const aiMaterial& material) {
  int model = 0;
  aiColor3D colour;
  ai_real exponent = 0;
  if (material.Get(AI_MATKEY_OBJ_ILLUM, model) != aiReturn_SUCCESS || model < 2 || model > 9 ||
      material.Get(AI_MATKEY_COLOR_SPECULAR, colour) != aiReturn_SUCCESS ||
      material.Get(AI_MATKEY_SHININESS, exponent) != aiReturn_SUCCESS || !(exponent > 0))
    return {};
  const ColourFactor factor{static_cast<double>(colour.r), static_cast<double>(colour.g),
                            static_cast<double>(colour.b)};
  return {factor.rounded(),
          static_cast<std::uint8_t>(std::lround(std::clamp(static_cast<double>(exponent), 1.0, 128.0)))};
}

/// glTF's alphaMode (glTF 2.0, 3.9.4, "Alpha Coverage"); formats without one take alpha as it is.
AlphaUse alpha_use(const aiMaterial& material) {
  aiString mode;
  if (material.Get("$mat.gltf.alphaMode", 0, 0, mode) != aiReturn_SUCCESS) return AlphaUse::by_image;
  if (std::string_view(mode.C_Str()) == "BLEND") return AlphaUse::blend;
  return std::string_view(mode.C_Str()) == "MASK" ? AlphaUse::cut_out : AlphaUse::opaque;
}

/// Opacity and cut-off: alpha is the material's times the texel's, and compared with a cut-off where it cuts out.
void read_opacity(const aiMaterial& material, FileMaterial& result) {
  ai_real opacity = 1;
  if (material.Get(AI_MATKEY_OPACITY, opacity) != aiReturn_SUCCESS) opacity = 1;
  if (result.alpha == AlphaUse::opaque) return;
  if (result.alpha != AlphaUse::cut_out) {
    result.opacity = to_byte(static_cast<double>(opacity));
    return;
  }
  ai_real cut_off = ai_real(0.5);
  if (material.Get("$mat.gltf.alphaCutoff", 0, 0, cut_off) != aiReturn_SUCCESS) cut_off = ai_real(0.5);
  if (opacity < cut_off) {
    result.opacity = 0;  // no texel can make up for it
    return;
  }
  if (opacity > 0) result.cut_off = std::max<std::uint8_t>(1, to_byte(static_cast<double>(cut_off / opacity)));
}

Wrap to_wrap(aiTextureMapMode mode) { return mode == aiTextureMapMode_Clamp ? Wrap::clamp : Wrap::repeat; }

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

SceneImage to_image(const aiScene& file, const aiString& name, const std::string& model) {
  const aiTexture* embedded = file.GetEmbeddedTexture(name.C_Str());
  if (embedded == nullptr) {
    const std::string path = image_path(name.C_Str(), model);
    return {path, path, {}};
  }
  SceneImage image{model + ": the texture inside it", {}, {}};
  // A compressed image's size stands in the width; others have no bytes of a file, and are refused as empty ones.
  if (embedded->mHeight == 0) {
    const auto* bytes = reinterpret_cast<const std::byte*>(embedded->pcData);
    image.bytes.assign(bytes, bytes + embedded->mWidth);
  }
  return image;
}

void read_texture(const aiScene& file, const aiMaterial& material, const std::string& model, FileMaterial& result) {
  for (const aiTextureType type : {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE}) {
    aiString name;
    unsigned set = 0;
    aiTextureMapMode modes[3] = {aiTextureMapMode_Wrap, aiTextureMapMode_Wrap, aiTextureMapMode_Wrap};
    if (material.GetTexture(type, 0, &name, nullptr, &set, nullptr, nullptr, modes) != aiReturn_SUCCESS ||
        name.length == 0)
      continue;
    result.texture_points = set;
    result.wrap_s = to_wrap(modes[0]);
    result.wrap_t = to_wrap(modes[1]);
    result.image = to_image(file, name, model);
    return;
  }
}

}  // namespace

std::uint8_t to_byte(double value) {
  return static_cast<std::uint8_t>(value > 0 ? std::min(value, 1.0) * 255 + 0.5 : 0);
}

Rgb888 ColourFactor::rounded() const { return {to_byte(red), to_byte(green), to_byte(blue)}; }

FileMaterial read_material(const aiScene& file, unsigned index, const std::string& path) {
  FileMaterial result;
  if (index >= file.mNumMaterials) return result;
  const aiMaterial& material = *file.mMaterials[index];
  result.colour = diffuse_colour(material);
  result.highlights = highlights_of(material);
  result.alpha = alpha_use(material);
  read_opacity(material, result);
  read_texture(file, material, path, result);
  return result;
}

}  // namespace spanline::sim
