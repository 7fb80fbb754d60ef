#include "convert/header_writer.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <string_view>

namespace spanline::sim {
namespace {

constexpr std::size_t line_length = 120;

/// The C++20 keywords and the words that <ciso646> makes of operators.
constexpr auto keywords = std::to_array<std::string_view>(
    {"alignas",     "alignof",   "and",        "and_eq",    "asm",      "auto",         "bitand",
     "bitor",       "bool",      "break",      "case",      "catch",    "char",         "char8_t",
     "char16_t",    "char32_t",  "class",      "compl",     "concept",  "const",        "consteval",
     "constexpr",   "constinit", "const_cast", "continue",  "co_await", "co_return",    "co_yield",
     "decltype",    "default",   "delete",     "do",        "double",   "dynamic_cast", "else",
     "enum",        "explicit",  "export",     "extern",    "false",    "float",        "for",
     "friend",      "goto",      "if",         "inline",    "int",      "long",         "mutable",
     "namespace",   "new",       "noexcept",   "not",       "not_eq",   "nullptr",      "operator",
     "or",          "or_eq",     "private",    "protected", "public",   "register",     "reinterpret_cast",
     "requires",    "return",    "short",      "signed",    "sizeof",   "static",       "static_assert",
     "static_cast", "struct",    "switch",     "template",  "this",     "thread_local", "throw",
     "true",        "try",       "typedef",    "typeid",    "typename", "union",        "unsigned",
     "using",       "virtual",   "void",       "volatile",  "wchar_t",  "while",        "xor",
     "xor_eq"});

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_word(char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '_'; }

/// Formats one table, its elements packed into lines.
template <class Table, class Format>
void append_table(std::string& text, const char* type, const char* name, const Table& table, Format format) {
  if (table.empty()) return;
  text += std::string("inline constexpr ") + type + " " + name + "[] = {";
  std::string line;
  for (const auto& element : table) {
    const std::string item = format(element) + ",";
    if (line.empty() || line.size() + 1 + item.size() > line_length) {
      text += line;
      line = "\n    " + item;
    } else {
      line += " " + item;
    }
  }
  text += line + "\n};\n";
}

std::string triple(long x, long y, long z) {
  std::array<char, 64> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "{%ld, %ld, %ld}", x, y, z);
  return buffer.data();
}

std::string colour_text(Rgb888 c) { return triple(c.red, c.green, c.blue); }
std::string normal_text(PackedNormal n) { return triple(n.x(), n.y(), n.z()); }

void append_tables(std::string& text, const CoreMesh& mesh) {
  append_table(text, "spanline::Vertex16", "vertices", mesh.vertices,
               [](const Vertex16& v) { return triple(v.x, v.y, v.z); });
  append_table(text, "std::uint16_t", "indices", mesh.indices, [](std::uint16_t i) { return std::to_string(i); });
  append_table(text, "std::uint8_t", "corners", mesh.corners, [](std::uint8_t c) { return std::to_string(c); });
  append_table(text, "spanline::PackedNormal", "polygon_normals", mesh.polygon_normals, normal_text);
  append_table(text, "spanline::PackedNormal", "vertex_normals", mesh.vertex_normals, normal_text);
  append_table(text, "spanline::Rgb888", "polygon_colours", mesh.polygon_colours, colour_text);
  append_table(text, "spanline::Rgb888", "vertex_colours", mesh.vertex_colours, colour_text);
  append_table(text, "spanline::TextureCoordinate", "texture_coordinates", mesh.texture_coordinates,
               [](TextureCoordinate c) { return "{" + std::to_string(c.s) + ", " + std::to_string(c.t) + "}"; });
  append_table(text, "std::uint8_t", "vertex_opacities", mesh.vertex_opacities,
               [](std::uint8_t o) { return std::to_string(o); });
}

void append_mesh(std::string& text, const CoreMesh& mesh, const std::string& name) {
  text += "inline constexpr spanline::Mesh " + name + "{\n";
  const std::vector<TableSize> filled = table_sizes(mesh);
  // Empty tables are named too: compilers warn of members without an initialiser.
  for (const std::string table :
       {"vertices", "wide_vertices", "indices", "corners", "polygon_normals", "vertex_normals", "polygon_colours",
        "vertex_colours", "texture_coordinates", "vertex_opacities"}) {
    const bool present = std::any_of(filled.begin(), filled.end(), [&](const TableSize& t) { return t.name == table; });
    text += "    ." + table + " = " + (present ? name + "_tables::" + table : "{}") + ",\n";
  }
  const auto& centre = mesh.bounds.centre;
  text += "    .offset = " + triple(mesh.offset.x, mesh.offset.y, mesh.offset.z) + ",\n";
  text += "    .step_exponent = " + std::to_string(mesh.step_exponent) + ",\n";
  text += "    .texture_exponent = " + std::to_string(mesh.texture_exponent) + ",\n";
  text += "    .bounds = {.centre = " + triple(centre.x, centre.y, centre.z) +
          ", .radius = " + std::to_string(mesh.bounds.radius) + "},\n};\n";
}

}  // namespace

std::string comment_safe(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c == '\\' || c == 127; }, '?');
  return text;
}

std::vector<TableSize> table_sizes(const CoreMesh& mesh) {
  std::vector<TableSize> sizes;
  const auto add = [&sizes](const char* name, const auto& table) {
    if (!table.empty()) sizes.push_back({name, table.size() * sizeof(table[0])});
  };
  add("vertices", mesh.vertices);
  add("indices", mesh.indices);
  add("corners", mesh.corners);
  add("polygon_normals", mesh.polygon_normals);
  add("vertex_normals", mesh.vertex_normals);
  add("polygon_colours", mesh.polygon_colours);
  add("vertex_colours", mesh.vertex_colours);
  add("texture_coordinates", mesh.texture_coordinates);
  add("vertex_opacities", mesh.vertex_opacities);
  return sizes;
}

std::string write_header(const CoreMesh& mesh, const std::string& name, const std::string& source) {
  std::string text = "// Made by `spanline convert` from " + comment_safe(source) + ": " +
                     std::to_string(mesh.vertices.size()) + " vertices, " +
                     std::to_string(mesh.view().triangle_count()) +
                     " triangles.\n#pragma once\n#include <spanline/model/mesh.hpp>\n\nnamespace spanline_models {\n\n";
  text += mesh_definition(mesh, name);
  text += "\n}  // namespace spanline_models\n";
  return text;
}

std::string mesh_definition(const CoreMesh& mesh, const std::string& name) {
  std::string text = "namespace " + name + "_tables {\n";
  append_tables(text, mesh);
  text += "}  // namespace " + name + "_tables\n\n";
  append_mesh(text, mesh, name);
  return text;
}

bool is_identifier(const std::string& name) {
  // Two underscores belong to the implementation wherever they stand, one with a capital behind it at the front.
  return !name.empty() && is_letter(name[0]) && std::all_of(name.begin(), name.end(), is_word) &&
         name.find("__") == std::string::npos && std::find(keywords.begin(), keywords.end(), name) == keywords.end();
}

std::string identifier_from(const std::string& path) {
  std::string name;
  for (const char c : std::filesystem::path(path).stem().string()) {
    if (is_word(c) && c != '_')
      name += c;
    else if (!name.empty() && name.back() != '_')
      name += '_';
  }
  if (name.empty() || !is_letter(name[0])) name = "model_" + name;
  return is_identifier(name) ? name : name + "_mesh";
}

}  // namespace spanline::sim
