#pragma once
#include <string>
#include <vector>

#include "scene/core_mesh.hpp"

namespace spanline::sim {

/// The bytes that a table takes in flash.
struct TableSize {
  std::string name;
  std::size_t bytes;
};

/// The tables of a mesh that are not empty.
[[nodiscard]] std::vector<TableSize> table_sizes(const CoreMesh& mesh);

/// A freestanding C++ header: constexpr tables and the object `spanline_models::NAME` of type spanline::Mesh.
/// `source` stands in its first comment.
[[nodiscard]] std::string write_header(const CoreMesh& mesh, const std::string& name, const std::string& source);

/// Its tables in a namespace NAME_tables, and the object NAME.
[[nodiscard]] std::string mesh_definition(const CoreMesh& mesh, const std::string& name);

/// What a comment can hold without ending its line or going on to the next.
[[nodiscard]] std::string comment_safe(std::string text);

/// True for a name that C++ takes for an object of the user's.
[[nodiscard]] bool is_identifier(const std::string& name);

/// An identifier made of a file's name.
[[nodiscard]] std::string identifier_from(const std::string& path);

}  // namespace spanline::sim
