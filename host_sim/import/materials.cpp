#include "import/materials.hpp"

#include <assimp/ObjMaterial.h>
#include <assimp/material.h>
#include <assimp/scene.h>

#include <algorithm>
#include <cmath>
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

/// Highlights of MTL, where its illumination model has them (Alias|Wavefront, "Material Library File", 1995: 2 to 9).
/// Only there is an exponent of this kind: glTF's roughness is none. Without one the importer says 0, which is no
/// highlight.
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
  result.texture = texture_of(file, material, path);
  return result;
}

}  // namespace spanline::sim
