#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "base/vector.hpp"
#include "spanline/model/colour.hpp"
#include "spanline/model/texture.hpp"

namespace spanline::sim {

/// A point of a texture: s to the right, t downwards, 1 is the whole texture.
struct TexturePoint {
  double s = 0, t = 0;
  friend bool operator==(TexturePoint, TexturePoint) = default;
};

/// An image that a model names, or holds: the bytes of a PNG or JPEG file, which nobody has looked at.
struct ImageSource {
  std::string name;  ///< for messages; empty where there is no image
  std::string path;  ///< empty where the bytes are here
  std::vector<std::byte> bytes;
  [[nodiscard]] bool exists() const { return !name.empty(); }
  friend bool operator==(const ImageSource&, const ImageSource&) = default;
};

/// What a texture is made of: one of the two at least.
struct SceneImage {
  ImageSource colours;    ///< none: white
  ImageSource opacities;  ///< in the place of the colours' alpha; none: that is what counts
  friend bool operator==(const SceneImage&, const SceneImage&) = default;
};

/// What a surface adds where it mirrors a light, as Material's members of these names.
struct Highlights {
  Rgb888 specular{0, 0, 0};     ///< black: none
  std::uint8_t shininess = 32;  ///< [1, 128]
  [[nodiscard]] bool shines() const { return specular != Rgb888{0, 0, 0}; }
  friend bool operator==(const Highlights&, const Highlights&) = default;
};

/// What the alpha of a part's texels is for.
enum class AlphaUse : std::uint8_t {
  by_image,  ///< images of alphas 0 and 255 alone cut out, others blend
  opaque,
  cut_out,
  blend,
};

/// How a part's texture goes on beyond its edge, along one axis: as the core has it, or every other time mirrored.
enum class PartWrap : std::uint8_t { repeat, clamp, mirror };

/// A model as it comes from its file, in world space and in doubles: right-handed, y up, front faces counter-clockwise.
///
/// Triangles stand in file order; a polygon of n corners is the fan (0,1,2), (0,2,3) … Every table is either empty or
/// complete. `polygon_triangles` says which fans the core may draw as one polygon.
struct Scene {
  /// A run of triangles that the file keeps together: a surface of its own where it is seen through.
  struct Part {
    static constexpr std::uint32_t no_image = std::numeric_limits<std::uint32_t>::max();
    std::uint32_t first = 0;         ///< triangle; the run goes to the next part's first
    std::uint32_t opacity = 255;     ///< 255ths
    std::uint32_t image = no_image;  ///< number of its texture's image
    Rgb888 colour{};                 ///< of its material, which a texture is multiplied with
    Highlights highlights{};
    AlphaUse alpha = AlphaUse::by_image;
    std::uint8_t cut_off = 128;  ///< least alpha of texels that are there, where they are cut out
    PartWrap wrap_s = PartWrap::repeat, wrap_t = PartWrap::repeat;
    friend bool operator==(const Part&, const Part&) = default;
  };
  using Triangle = std::array<std::uint32_t, 3>;
  static constexpr unsigned most_fan_triangles = 6;  ///< of a polygon of the core, which has up to 8 corners

  std::vector<Vector3> positions;
  std::vector<Vector3> vertex_normals;         ///< unit length, one a vertex
  std::vector<Rgb888> vertex_colours;          ///< one a vertex
  std::vector<std::uint8_t> vertex_opacities;  ///< one a vertex, 255ths of its part's
  std::vector<TexturePoint> texture_points;    ///< one a vertex
  std::vector<Triangle> triangles;             ///< vertex numbers
  std::vector<Vector3> polygon_normals;        ///< one a triangle: its polygon's (Newell), zero if it has no area
  std::vector<Rgb888> polygon_colours;         ///< one a triangle
  /// How many triangles each polygon's fan has, 1 … `most_fan_triangles`; those of larger polygons stand alone. Parts
  /// begin with a polygon. Empty: all triangles stand alone.
  std::vector<std::uint8_t> polygon_triangles;
  /// One a triangle: the number of its object, which is what the file calls one: an object of OBJ (`o`), a node of glTF
  /// that has a mesh, a solid of STL. Empty: all triangles are of one object.
  std::vector<std::uint32_t> triangle_objects;
  std::vector<Part> parts;  ///< in file order; empty: one, opaque
  std::vector<SceneImage> images;
  Rgb888 colour{};                 ///< of everything, where there are no tables of colours
  bool normals_from_file = false;  ///< the file itself has vertex normals
};

/// Whether anything shows what lies behind it.
[[nodiscard]] bool is_see_through(const Scene& scene);

/// Whether any part has a texture of its own, and coordinates for it.
[[nodiscard]] bool is_textured(const Scene& scene);

/// Whether any part has highlights that differ from another's.
[[nodiscard]] bool has_different_highlights(const Scene& scene);

/// Gives every part the same highlights, whatever the model says.
void set_highlights(Scene& scene, const Highlights& highlights);

/// Multiplies every part's opacity by a factor in [0, 1].
void fade(Scene& scene, double opacity);

/// The box around all vertices that a triangle uses.
struct BoundingBox {
  Vector3 low, high;
  [[nodiscard]] Vector3 centre() const { return low + (high - low) * 0.5; }
};
[[nodiscard]] BoundingBox bounding_box(const Scene& scene);

/// The scene with vertices of equal attributes made one and unused ones dropped, in order of first use, so that
/// triangles that share an edge share its vertices.
[[nodiscard]] Scene welded(const Scene& scene);

/// Fills `vertex_normals` where the file has none: the mean of the polygons around a position, weighted by their area.
void complete_vertex_normals(Scene& scene);

/// Fills `polygon_colours` from `vertex_colours`, the mean of the three corners, where there are none.
void complete_polygon_colours(Scene& scene);

/// Makes one `colour` of `polygon_colours` that are all the same.
void simplify_colours(Scene& scene);

/// Gives every triangle vertices of its own, with its polygon's colour, unless there are vertex colours already.
void polygon_colours_to_vertices(Scene& scene);

}  // namespace spanline::sim
