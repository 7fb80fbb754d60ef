#include "import/assimp_import.hpp"

#include <sys/stat.h>

#include <assimp/DefaultIOSystem.h>
#include <assimp/MemoryIOWrapper.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <stdexcept>

#include "import/scene_builder.hpp"

namespace spanline::sim {
namespace {

/// Serves the main file from memory and other regular files from the disk; a model cannot name a device.
class ModelFiles final : public Assimp::DefaultIOSystem {
 public:
  ModelFiles(std::string path, const std::string& content) : path_(std::move(path)), content_(content) {}

  bool Exists(const char* file) const override { return path_ == file || is_regular(file); }

  Assimp::IOStream* Open(const char* file, const char* mode) override {
    if (path_ == file)
      return new Assimp::MemoryIOStream(reinterpret_cast<const std::uint8_t*>(content_.data()), content_.size());
    return is_regular(file) ? DefaultIOSystem::Open(file, mode) : nullptr;
  }

 private:
  static bool is_regular(const char* file) {
    struct stat status {};
    return stat(file, &status) == 0 && S_ISREG(status.st_mode);
  }

  std::string path_;
  const std::string& content_;
};

/// Messages may be several lines long; one is for the user.
std::string first_line(std::string message) {
  message.erase(std::min(message.find_first_of("\r\n"), message.size()));
  if (message.find("bad_alloc") != std::string::npos) return "it asks for too much memory";
  return message.empty() ? "unknown error" : message;
}

}  // namespace

Scene read_with_assimp(const std::string& path, ModelFormat format, const std::string& content) {
  Assimp::Importer importer;
  importer.SetIOHandler(new ModelFiles(path, content));
  // No post-processing: triangles must stay in file order, and polygons are cut into fans here.
  const aiScene* scene = importer.ReadFile(path, 0);
  if (scene == nullptr || (scene->mFlags & AI_SCENE_FLAGS_INCOMPLETE) != 0 || scene->mRootNode == nullptr)
    throw std::runtime_error("cannot be read: " + first_line(importer.GetErrorString()));
  // The normals of an STL file belong to its triangles; as normals of vertices they would only be flat.
  return build_scene(*scene, path, format != ModelFormat::stl);
}

}  // namespace spanline::sim
