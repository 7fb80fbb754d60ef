#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "import/material_texture.hpp"
#include "scene/scene.hpp"

struct aiMaterial;
struct aiScene;

namespace spanline::sim {

/// A colour whose channels are linear in 0 … 1.
struct ColourFactor {
  double red = 1, green = 1, blue = 1;
  /// Whatever lies outside, or is no number, is clamped.
  [[nodiscard]] Rgb888 rounded() const;
  friend ColourFactor operator*(ColourFactor a, ColourFactor b) {
    return {a.red * b.red, a.green * b.green, a.blue * b.blue};
  }
};

/// Linear in 0 … 1 as 255ths; whatever lies outside, or is no number, is clamped.
[[nodiscard]] std::uint8_t to_byte(double value);

/// What a file's material says of a surface.
struct FileMaterial {
  std::optional<ColourFactor> colour;  ///< the diffuse colour, where it is the file's own
  Highlights highlights;
  std::uint32_t opacity = 255;
  AlphaUse alpha = AlphaUse::by_image;
  std::uint8_t cut_off = 128;  ///< least alpha of texels that are there
  MaterialTexture texture;
};

/// Material `index` of a file that lies at `path`; nothing special where there is none.
[[nodiscard]] FileMaterial read_material(const aiScene& file, unsigned index, const std::string& path);

}  // namespace spanline::sim
