#include "model_files.hpp"

#include <array>
#include <cstdint>
#include <cstring>

#include "image/png.hpp"

namespace spanline::sim::test {
namespace {

template <class T>
void append_bytes(std::string& bytes, T value) {
  std::array<char, sizeof(T)> raw{};
  std::memcpy(raw.data(), &value, sizeof(T));
  bytes.append(raw.data(), raw.size());
}

constexpr std::array<float, 9> corners{0, 0, 0, 1, 0, 0, 0, 1, 0};

std::string corner_bytes() {
  std::string bytes;
  for (const float c : corners) append_bytes(bytes, c);
  return bytes;
}

std::string ply_header(const std::string& format) {
  return "ply\nformat " + format +
         " 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
         "property list uchar int vertex_indices\nend_header\n";
}

std::string gltf_json(const std::string& node, const std::string& material, const std::string& uri) {
  return std::string(R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0)") +
         (node.empty() ? "" : ", " + node) + R"(}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0})" +
         (material.empty() ? "" : R"(, "material": 0)") + "}]}]," +
         (material.empty() ? "" : R"("materials": [)" + material + "],") +
         R"("accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
             "min": [0, 0, 0], "max": [1, 1, 0]}],
             "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 36}], "buffers": [{"byteLength": 36)" +
         uri + "}]}";
}

}  // namespace

std::string base64(const std::string& bytes) {
  constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : digits[(group >> (18 - 6 * k)) & 63];
  }
  return text;
}

std::string textured_gltf(const std::string& image_uri, const std::string& material, const std::string& sampler) {
  std::string bytes;
  for (const float c : {-1.F, -1.F, 0.F, 3.F, -1.F, 0.F, -1.F, 3.F, 0.F}) append_bytes(bytes, c);
  // glTF's t counts downwards.
  for (const float c : {0.F, 1.F, 2.F, 1.F, 0.F, -1.F}) append_bytes(bytes, c);
  return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "material": 0}]}],
    "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0})" +
         material + R"(}],
    "textures": [{"source": 0, "sampler": 0}], "samplers": [)" +
         sampler + R"(], "images": [{"uri": ")" + image_uri + R"("}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [-1, -1, 0],
                   "max": [3, 3, 0]},
                  {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2"}],
    "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 24}],
    "buffers": [{"byteLength": 60, "uri": "data:application/octet-stream;base64,)" +
         base64(bytes) + R"("}]})";
}

std::string triangle_obj() { return "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"; }

std::string triangle_ply() { return ply_header("ascii") + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"; }

std::string triangle_binary_ply() {
  std::string bytes = ply_header("binary_little_endian") + corner_bytes() + '\3';
  for (const std::int32_t index : {0, 1, 2}) append_bytes(bytes, index);
  return bytes;
}

std::string triangle_stl() {
  return "solid test\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
         "endsolid test\n";
}

std::string triangle_binary_stl() {
  std::string bytes(80, ' ');
  append_bytes(bytes, std::uint32_t{1});
  for (const float n : {0.0F, 0.0F, 1.0F}) append_bytes(bytes, n);
  bytes += corner_bytes();
  append_bytes(bytes, std::uint16_t{0});
  return bytes;
}

std::string triangle_gltf(const std::string& node, const std::string& material) {
  return gltf_json(node, material,
                   R"(, "uri": "data:application/octet-stream;base64,)" + base64(corner_bytes()) + "\"");
}

std::string triangle_glb() {
  std::string json = gltf_json("", "", "");
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::string binary = corner_bytes();
  std::string bytes = "glTF";
  append_bytes(bytes, std::uint32_t{2});
  append_bytes(bytes, static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + binary.size()));
  append_bytes(bytes, static_cast<std::uint32_t>(json.size()));
  bytes += "JSON" + json;
  append_bytes(bytes, static_cast<std::uint32_t>(binary.size()));
  return bytes + std::string("BIN\0", 4) + binary;
}

std::string cube_obj() {
  return "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
         "f 5 6 7 8\nf 2 1 4 3\nf 1 5 8 4\nf 6 2 3 7\nf 8 7 3 4\nf 1 2 6 5\n";
}

std::string textured_square() {
  return "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n";
}

Picture numbered_picture(int width, int height) {
  Picture picture(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      picture.at(x, y) = {static_cast<std::uint8_t>(x * 8), static_cast<std::uint8_t>(y * 8), 255};
  return picture;
}

std::string png_bytes(const Picture& picture) {
  const std::vector<std::byte> bytes = encode_png(picture);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace spanline::sim::test
