#include "import/model_file.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <utility>

#include "base/failure.hpp"
#include "import/assimp_import.hpp"
#include "import/isolated.hpp"
#include "import/model_format.hpp"
#include "import/obj_objects.hpp"
#include "import/text_checks.hpp"
#include "scene/scene_bytes.hpp"

namespace spanline::sim {
namespace {

ModelFormat format_of(const std::string& path) {
  constexpr std::array<std::pair<const char*, ModelFormat>, 5> endings{{{".obj", ModelFormat::obj},
                                                                        {".gltf", ModelFormat::gltf},
                                                                        {".glb", ModelFormat::glb},
                                                                        {".ply", ModelFormat::ply},
                                                                        {".stl", ModelFormat::stl}}};
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const auto& [name, format] : endings)
    if (ending == name) return format;
  throw file_failure(path, "not a model that can be read: its name must end in .obj, .gltf, .glb, .ply or .stl");
}

void check_regular(const std::string& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0)
    throw file_failure(path, std::string("cannot be read: ") + std::strerror(errno));
  if (S_ISDIR(status.st_mode)) throw file_failure(path, "is a folder, not a model");
  if (!S_ISREG(status.st_mode)) throw file_failure(path, "is not a regular file");
  if (status.st_size == 0) throw file_failure(path, "is empty");
}

std::string read_whole(const std::string& path) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) throw file_failure(path, std::string("cannot be read: ") + std::strerror(errno));
  std::string content;
  std::array<char, 65536> block{};
  while (const std::size_t count = std::fread(block.data(), 1, block.size(), file.get()))
    content.append(block.data(), count);
  if (std::ferror(file.get()) != 0) throw file_failure(path, std::string("cannot be read: ") + std::strerror(errno));
  return content;
}

}  // namespace

Scene import_model(const std::string& path) {
  check_regular(path);
  const ModelFormat format = format_of(path);
  std::string content = read_whole(path);
  const IsolatedResult result = run_isolated("reading " + path, [&] {
    check_complete(format, content);
    if (format != ModelFormat::obj) return to_bytes(read_with_assimp(path, format, content));
    std::vector<std::uint32_t> objects = objects_of_obj(content);
    blank_obj_groups(content);
    Scene scene = read_with_assimp(path, format, content);
    if (objects.size() == scene.triangles.size()) scene.triangle_objects = std::move(objects);
    return to_bytes(scene);
  });
  if (!result.error.empty()) throw file_failure(path, result.error);
  std::optional<Scene> scene = scene_from_bytes(result.bytes);
  if (!scene) throw file_failure(path, "cannot be read: the importer broke down on it");
  return *std::move(scene);
}

}  // namespace spanline::sim
