#include "import/scene_builder.hpp"

#include <assimp/material.h>
#include <assimp/scene.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace spanline::sim {
namespace {

Vector3 to_vector(const aiVector3D& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

Affine to_affine(const aiMatrix4x4& m) {
  const auto row = [](ai_real x, ai_real y, ai_real z) {
    return Vector3{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
  };
  return {{row(m.a1, m.a2, m.a3), row(m.b1, m.b2, m.b3), row(m.c1, m.c2, m.c3)}, row(m.a4, m.b4, m.c4)};
}

/// Linear in 0 … 1; whatever lies outside, or is no number, is clamped.
std::uint8_t to_byte(double value) {
  return static_cast<std::uint8_t>(value > 0 ? std::min(value, 1.0) * 255 + 0.5 : 0);
}

struct ColourFactor {
  double red = 1, green = 1, blue = 1;
  [[nodiscard]] Rgb888 rounded() const { return {to_byte(red), to_byte(green), to_byte(blue)}; }
  friend ColourFactor operator*(ColourFactor a, ColourFactor b) {
    return {a.red * b.red, a.green * b.green, a.blue * b.blue};
  }
};

ColourFactor to_factor(const aiColor4D& c) {
  return {static_cast<double>(c.r), static_cast<double>(c.g), static_cast<double>(c.b)};
}

/// Importers make a material up where a file has none: without a name or with the default one, white or 0.6 grey.
bool made_up(const aiMaterial& material, const aiColor4D& colour) {
  aiString name;
  const bool named = material.Get(AI_MATKEY_NAME, name) == aiReturn_SUCCESS;
  if (named && std::string_view(name.C_Str()) != AI_DEFAULT_MATERIAL_NAME) return false;
  return colour.r == colour.g && colour.g == colour.b && (colour.r == ai_real(1) || colour.r == ai_real(0.6));
}

/// The diffuse colour of a material that is the file's own.
std::optional<ColourFactor> material_colour(const aiScene& file, unsigned index) {
  if (index >= file.mNumMaterials) return std::nullopt;
  const aiMaterial& material = *file.mMaterials[index];
  aiColor4D colour;
  if (material.Get(AI_MATKEY_COLOR_DIFFUSE, colour) != aiReturn_SUCCESS || made_up(material, colour))
    return std::nullopt;
  return to_factor(colour);
}

/// glTF's alphaMode (glTF 2.0, 3.9.4, "Alpha Coverage"); formats without one take alpha as it is.
enum class AlphaMode : std::uint8_t { opaque, mask, blend };

AlphaMode alpha_mode(const aiScene& file, unsigned index) {
  aiString mode;
  if (index >= file.mNumMaterials || file.mMaterials[index]->Get("$mat.gltf.alphaMode", 0, 0, mode) != aiReturn_SUCCESS)
    return AlphaMode::blend;
  if (std::string_view(mode.C_Str()) == "BLEND") return AlphaMode::blend;
  return std::string_view(mode.C_Str()) == "MASK" ? AlphaMode::mask : AlphaMode::opaque;
}

/// What of a material is seen: its opacity, unless its alphaMode says otherwise.
std::uint32_t material_opacity(const aiScene& file, unsigned index) {
  constexpr std::uint32_t opaque = 255;
  if (index >= file.mNumMaterials) return opaque;
  const aiMaterial& material = *file.mMaterials[index];
  ai_real opacity = 1;
  if (material.Get(AI_MATKEY_OPACITY, opacity) != aiReturn_SUCCESS) return opaque;
  const AlphaMode mode = alpha_mode(file, index);
  if (mode == AlphaMode::blend) return to_byte(static_cast<double>(opacity));
  if (mode == AlphaMode::opaque) return opaque;
  ai_real cutoff = ai_real(0.5);
  if (material.Get("$mat.gltf.alphaCutoff", 0, 0, cutoff) != aiReturn_SUCCESS) cutoff = ai_real(0.5);
  return opacity < cutoff ? 0 : opaque;
}

/// The sum of the fan's cross products is Newell's normal (Sutherland, Sproull, Schumacker 1974): it holds for polygons
/// that are not quite planar, too.
Vector3 newell_normal(const std::vector<Vector3>& corners) {
  Vector3 sum;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    sum = sum + cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  return normalised(sum);
}

class SceneBuilder {
 public:
  SceneBuilder(const aiScene& file, bool keep_normals) : file_(file), keep_normals_(keep_normals) {
    for (unsigned i = 0; i < file.mNumMeshes; ++i) {
      const aiMesh& mesh = *file.mMeshes[i];
      any_normals_ = any_normals_ || (keep_normals && mesh.HasNormals());
      any_vertex_colours_ = any_vertex_colours_ || mesh.HasVertexColors(0);
      any_vertex_opacities_ = any_vertex_opacities_ || has_opacities(mesh);
      any_texture_points_ = any_texture_points_ || mesh.HasTextureCoords(0);
      any_materials_ = any_materials_ || material_colour(file, mesh.mMaterialIndex).has_value();
    }
  }

  Scene build() {
    struct Visit {
      const aiNode* node;
      Affine parent;
    };
    // An explicit stack, children pushed backwards: file order, and no recursion as deep as a hostile file likes.
    std::vector<Visit> stack{{file_.mRootNode, Affine{}}};
    while (!stack.empty()) {
      const Visit visit = stack.back();
      stack.pop_back();
      const Affine world = visit.parent * to_affine(visit.node->mTransformation);
      for (unsigned i = 0; i < visit.node->mNumMeshes; ++i) add_mesh(visit.node->mMeshes[i], world);
      for (unsigned i = visit.node->mNumChildren; i-- > 0;) stack.push_back({visit.node->mChildren[i], world});
    }
    if (scene_.triangles.empty()) throw std::runtime_error("has no triangle");
    scene_.normals_from_file = any_normals_;
    return std::move(scene_);
  }

 private:
  void add_mesh(unsigned number, const Affine& world) {
    if (number >= file_.mNumMeshes) throw std::runtime_error("refers to a mesh that does not exist");
    const aiMesh& mesh = *file_.mMeshes[number];
    const bool has_polygons = std::any_of(mesh.mFaces, mesh.mFaces + mesh.mNumFaces,
                                          [](const aiFace& face) { return face.mNumIndices >= 3; });
    if (!has_polygons) return;
    first_vertex_ = scene_.positions.size();
    if (first_vertex_ + mesh.mNumVertices > std::numeric_limits<std::uint32_t>::max())
      throw std::runtime_error("has too many vertices");
    const std::optional<ColourFactor> colour = material_colour(file_, mesh.mMaterialIndex);
    add_vertices(mesh, world, colour.value_or(ColourFactor{}));
    const bool mirrored = world.determinant() < 0;
    scene_.parts.push_back(
        {static_cast<std::uint32_t>(scene_.triangles.size()), material_opacity(file_, mesh.mMaterialIndex)});
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) add_polygon(mesh, mesh.mFaces[i], mirrored);
    if (any_materials_)
      scene_.polygon_colours.resize(scene_.triangles.size(), colour.value_or(ColourFactor{}).rounded());
  }

  void add_vertices(const aiMesh& mesh, const Affine& world, ColourFactor colour) {
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
      const Vector3 position = world.point(to_vector(mesh.mVertices[i]));
      if (!finite(position)) throw std::runtime_error("has a coordinate that is not a finite number");
      scene_.positions.push_back(position);
      if (any_texture_points_) scene_.texture_points.push_back(texture_point(mesh, i));
      if (any_normals_) scene_.vertex_normals.push_back(vertex_normal(mesh, i, world));
      if (any_vertex_opacities_)
        scene_.vertex_opacities.push_back(has_opacities(mesh) ? to_byte(static_cast<double>(mesh.mColors[0][i].a))
                                                              : std::uint8_t{255});
      if (any_vertex_colours_)
        scene_.vertex_colours.push_back(mesh.HasVertexColors(0) ? (to_factor(mesh.mColors[0][i]) * colour).rounded()
                                                                : colour.rounded());
    }
  }

  /// Whether any vertex is not opaque, and the material honours that.
  [[nodiscard]] bool has_opacities(const aiMesh& mesh) const {
    if (!mesh.HasVertexColors(0) || alpha_mode(file_, mesh.mMaterialIndex) != AlphaMode::blend) return false;
    return std::any_of(mesh.mColors[0], mesh.mColors[0] + mesh.mNumVertices,
                       [](const aiColor4D& colour) { return colour.a < ai_real(1); });
  }

  Vector3 vertex_normal(const aiMesh& mesh, unsigned vertex, const Affine& world) const {
    if (!keep_normals_ || !mesh.HasNormals()) return {};
    const Vector3 normal = to_vector(mesh.mNormals[vertex]);
    if (!finite(normal)) throw std::runtime_error("has a normal that is not a finite number");
    return normalised(world.normal(normalised(normal)));
  }

  /// Assimp's t counts upwards.
  static TexturePoint texture_point(const aiMesh& mesh, unsigned vertex) {
    if (!mesh.HasTextureCoords(0)) return {};
    const Vector3 point = to_vector(mesh.mTextureCoords[0][vertex]);
    if (!finite(point)) throw std::runtime_error("has a texture coordinate that is not a finite number");
    return {point.x, 1 - point.y};
  }

  void add_polygon(const aiMesh& mesh, const aiFace& face, bool mirrored) {
    if (face.mNumIndices < 3) return;
    std::vector<Vector3> corners;
    for (unsigned k = 0; k < face.mNumIndices; ++k) {
      if (face.mIndices[k] >= mesh.mNumVertices) throw std::runtime_error("has a vertex index out of range");
      corners.push_back(scene_.positions[first_vertex_ + face.mIndices[k]]);
    }
    const Vector3 normal = newell_normal(corners);
    const auto vertex = [&](unsigned corner) {
      return static_cast<std::uint32_t>(first_vertex_ + face.mIndices[corner]);
    };
    for (unsigned k = 1; k + 1 < face.mNumIndices; ++k) {
      const std::uint32_t a = vertex(0), b = vertex(k), c = vertex(k + 1);
      scene_.triangles.push_back(mirrored ? Scene::Triangle{a, c, b} : Scene::Triangle{a, b, c});
      scene_.polygon_normals.push_back(mirrored ? -normal : normal);
    }
  }

  const aiScene& file_;
  bool keep_normals_;
  bool any_normals_ = false;
  bool any_vertex_colours_ = false;
  bool any_vertex_opacities_ = false;
  bool any_texture_points_ = false;
  bool any_materials_ = false;
  std::size_t first_vertex_ = 0;
  Scene scene_;
};

}  // namespace

Scene build_scene(const aiScene& file, bool keep_normals) { return SceneBuilder(file, keep_normals).build(); }

}  // namespace spanline::sim
