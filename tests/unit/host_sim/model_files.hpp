#pragma once
#include <string>

#include "image/picture.hpp"

/// Small model files and pictures, made by the tests that read them.
namespace spanline::sim::test {

/// A triangle (0,0,0) (1,0,0) (0,1,0) in each format.
[[nodiscard]] std::string triangle_obj();
[[nodiscard]] std::string triangle_ply();
[[nodiscard]] std::string triangle_binary_ply();
[[nodiscard]] std::string triangle_stl();
[[nodiscard]] std::string triangle_binary_stl();
/// `node` is the JSON of the members of its node, such as "\"scale\": [1, 2, 3]".
[[nodiscard]] std::string triangle_gltf(const std::string& node = "", const std::string& material = "");
[[nodiscard]] std::string triangle_glb();

/// A triangle that covers the square from (−1,−1,0) to (1,1,0), on which its texture lies once and upright. `material`
/// is the rest of the material's JSON behind its baseColorTexture: further members of pbrMetallicRoughness, `}`, and
/// the material's own.
[[nodiscard]] std::string textured_gltf(const std::string& image_uri, const std::string& material = "}",
                                        const std::string& sampler = "{}");

[[nodiscard]] std::string base64(const std::string& bytes);

/// A cube of edge 2 about the origin, six quadrilaterals counter-clockwise from outside.
[[nodiscard]] std::string cube_obj();

/// A square of two units that faces +z, its texture upright.
[[nodiscard]] std::string textured_square();

/// Each texel its own colour of five bits a channel.
[[nodiscard]] Picture numbered_picture(int width, int height);
/// A picture as a PNG file.
[[nodiscard]] std::string png_bytes(const Picture& picture);

}  // namespace spanline::sim::test
