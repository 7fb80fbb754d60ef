#include "import/scene_builder.hpp"

#include <assimp/scene.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "import/materials.hpp"

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

ColourFactor to_factor(const aiColor4D& c) {
  return {static_cast<double>(c.r), static_cast<double>(c.g), static_cast<double>(c.b)};
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
  SceneBuilder(const aiScene& file, const std::string& path, bool keep_normals)
      : file_(file), keep_normals_(keep_normals) {
    for (unsigned i = 0; i < file.mNumMaterials; ++i) materials_.push_back(read_material(file, i, path));
    for (unsigned i = 0; i < file.mNumMeshes; ++i) {
      const aiMesh& mesh = *file.mMeshes[i];
      const FileMaterial& material = material_of(mesh);
      any_normals_ = any_normals_ || (keep_normals && mesh.HasNormals());
      any_vertex_colours_ = any_vertex_colours_ || mesh.HasVertexColors(0);
      any_vertex_opacities_ = any_vertex_opacities_ || has_opacities(mesh);
      any_texture_points_ = any_texture_points_ || mesh.HasTextureCoords(material.texture.points);
      any_materials_ = any_materials_ || material.colour.has_value();
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
      const std::size_t before = scene_.triangles.size();
      for (unsigned i = 0; i < visit.node->mNumMeshes; ++i) add_mesh(visit.node->mMeshes[i], world);
      // A node with triangles is an object, whose number is that of its first triangle.
      scene_.triangle_objects.resize(scene_.triangles.size(), static_cast<std::uint32_t>(before));
      for (unsigned i = visit.node->mNumChildren; i-- > 0;) stack.push_back({visit.node->mChildren[i], world});
    }
    if (scene_.triangles.empty()) throw std::runtime_error("has no triangle");
    if (scene_.triangle_objects.back() == scene_.triangle_objects.front()) scene_.triangle_objects.clear();
    scene_.normals_from_file = any_normals_;
    if (scene_.polygon_triangles.size() == scene_.triangles.size()) scene_.polygon_triangles.clear();
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
    const FileMaterial& material = material_of(mesh);
    const ColourFactor colour = material.colour.value_or(ColourFactor{});
    add_vertices(mesh, world, material, colour);
    const bool mirrored = world.determinant() < 0;
    add_part(mesh, material, colour);
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) add_polygon(mesh, mesh.mFaces[i], mirrored);
    if (any_materials_) scene_.polygon_colours.resize(scene_.triangles.size(), colour.rounded());
  }

  void add_part(const aiMesh& mesh, const FileMaterial& material, ColourFactor colour) {
    Scene::Part part;
    part.first = static_cast<std::uint32_t>(scene_.triangles.size());
    part.opacity = material.opacity;
    part.colour = colour.rounded();
    part.highlights = material.highlights;
    part.alpha = material.alpha;
    part.cut_off = material.cut_off;
    part.wrap_s = material.texture.wrap_s;
    part.wrap_t = material.texture.wrap_t;
    if (material.texture.image && mesh.HasTextureCoords(material.texture.points))
      part.image = number_of(*material.texture.image);
    scene_.parts.push_back(part);
  }

  std::uint32_t number_of(const SceneImage& image) {
    const auto found = std::find(scene_.images.begin(), scene_.images.end(), image);
    const auto number = static_cast<std::uint32_t>(found - scene_.images.begin());
    if (found == scene_.images.end()) scene_.images.push_back(image);
    return number;
  }

  [[nodiscard]] const FileMaterial& material_of(const aiMesh& mesh) const {
    static const FileMaterial none;
    return mesh.mMaterialIndex < materials_.size() ? materials_[mesh.mMaterialIndex] : none;
  }

  void add_vertices(const aiMesh& mesh, const Affine& world, const FileMaterial& material, ColourFactor colour) {
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
      const Vector3 position = world.point(to_vector(mesh.mVertices[i]));
      if (!finite(position)) throw std::runtime_error("has a coordinate that is not a finite number");
      scene_.positions.push_back(position);
      if (any_texture_points_) scene_.texture_points.push_back(texture_point(mesh, material.texture, i));
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
    const AlphaUse alpha = material_of(mesh).alpha;
    if (!mesh.HasVertexColors(0) || alpha == AlphaUse::opaque || alpha == AlphaUse::cut_out) return false;
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
  static TexturePoint texture_point(const aiMesh& mesh, const MaterialTexture& texture, unsigned vertex) {
    if (!mesh.HasTextureCoords(texture.points)) return {};
    const Vector3 stored = to_vector(mesh.mTextureCoords[texture.points][vertex]);
    const TexturePoint point = texture.transform({stored.x, 1 - stored.y});
    if (!std::isfinite(point.s) || !std::isfinite(point.t))
      throw std::runtime_error("has a texture coordinate that is not a finite number");
    return point;
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
    // A mirrored polygon is no fan of its triangles in file order, which is what ids count.
    const unsigned triangles = face.mNumIndices - 2;
    if (triangles <= Scene::most_fan_triangles && !mirrored)
      scene_.polygon_triangles.push_back(static_cast<std::uint8_t>(triangles));
    else
      scene_.polygon_triangles.insert(scene_.polygon_triangles.end(), triangles, 1);
  }

  const aiScene& file_;
  std::vector<FileMaterial> materials_;
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

Scene build_scene(const aiScene& file, const std::string& path, bool keep_normals) {
  return SceneBuilder(file, path, keep_normals).build();
}

}  // namespace spanline::sim
