#include "convert/texture_writer.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

#include "base/failure.hpp"
#include "convert/header_writer.hpp"

namespace spanline::sim {
namespace {

struct NamedFormat {
  TexelFormat format;
  const char *name, *enumerator;
};
constexpr std::array<NamedFormat, 5> formats{{{TexelFormat::rgb565, "rgb565", "rgb565"},
                                              {TexelFormat::rgb565_cutout, "rgb565-cutout", "rgb565_cutout"},
                                              {TexelFormat::argb4444, "argb4444", "argb4444"},
                                              {TexelFormat::palette16, "palette16", "palette16"},
                                              {TexelFormat::palette256, "palette256", "palette256"}}};

const NamedFormat& named(TexelFormat format) {
  return *std::find_if(formats.begin(), formats.end(), [format](const NamedFormat& f) { return f.format == format; });
}

template <class Table>
void append_table(std::string& text, const char* type, const char* name, const Table& table) {
  if (table.empty()) return;
  text += std::string("inline constexpr ") + type + " " + name + "[] = {";
  const std::size_t a_line = sizeof(table[0]) == 2 ? 15 : 20;
  for (std::size_t i = 0; i < table.size(); ++i) {
    std::array<char, 16> number{};
    std::snprintf(number.data(), number.size(), sizeof(table[0]) == 2 ? "0x%04x," : "0x%02x,", unsigned{table[i]});
    text += (i % a_line == 0 ? "\n    " : " ") + std::string(number.data());
  }
  text += "\n};\n";
}

const char* wrap_text(Wrap wrap) { return wrap == Wrap::clamp ? "clamp" : "repeat"; }

std::string line(const char* memory, const std::string& what, std::size_t bytes) {
  std::array<char, 160> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%-5s  %-44s %9zu bytes\n", memory, what.c_str(), bytes);
  return buffer.data();
}

}  // namespace

const char* to_string(TexelFormat format) { return named(format).name; }

TexelFormat find_texel_format(const std::string& option, const std::string& name) {
  std::string names;
  for (const NamedFormat& format : formats) {
    if (name == format.name) return format.format;
    names += (names.empty() ? "" : ", ") + std::string(format.name);
  }
  throw UsageError(option + ": '" + name + "' is unknown; there is " + names);
}

Wrap parse_wrap(const std::string& option, const std::string& name) {
  for (const Wrap wrap : {Wrap::repeat, Wrap::clamp})
    if (name == wrap_text(wrap)) return wrap;
  throw UsageError(option + ": '" + name + "' is neither repeat nor clamp");
}

std::string write_texture_header(const TextureImage& texture, const std::string& name, const std::string& source) {
  const Texture& shape = texture.shape;
  std::string text = "// Made by `spanline convert` from " + comment_safe(source) + ": " +
                     std::to_string(1u << shape.log2_width) + " x " + std::to_string(1u << shape.log2_height) + ", " +
                     to_string(shape.format) + ", " + std::to_string(shape.levels) +
                     (shape.levels == 1 ? " level" : " levels") +
                     ".\n#pragma once\n#include <spanline/model/texture.hpp>\n\nnamespace spanline_textures {\n\n";
  return text + texture_definition(texture, name) + "\n}  // namespace spanline_textures\n";
}

std::string texture_definition(const TextureImage& texture, const std::string& name) {
  const Texture& shape = texture.shape;
  std::string text = "namespace " + name + "_tables {\n";
  append_table(text, "std::uint16_t", "words", texture.words);
  append_table(text, "std::uint8_t", "bytes", texture.bytes);
  append_table(text, "std::uint16_t", "palette", texture.palette);
  text += "}  // namespace " + name + "_tables\n\ninline constexpr spanline::Texture " + name + "{\n";
  text += std::string("    .format = spanline::TexelFormat::") + named(shape.format).enumerator + ",\n";
  text += "    .log2_width = " + std::to_string(shape.log2_width) + ",\n";
  text += "    .log2_height = " + std::to_string(shape.log2_height) + ",\n";
  text += "    .levels = " + std::to_string(shape.levels) + ",\n";
  text += std::string("    .wrap_s = spanline::Wrap::") + wrap_text(shape.wrap_s) + ",\n";
  text += std::string("    .wrap_t = spanline::Wrap::") + wrap_text(shape.wrap_t) + ",\n";
  const auto table = [&](const char* member, bool present) {
    text += std::string("    .") + member + " = " + (present ? name + "_tables::" + member : "{}") + ",\n";
  };
  table("words", !texture.words.empty());
  table("bytes", !texture.bytes.empty());
  table("palette", !texture.palette.empty());
  return text + "};\n";
}

std::string texture_report(const TextureImage& texture) {
  const Texture view = texture.view();
  std::string text;
  const std::size_t entry = texture.words.empty() ? 1 : 2;
  text += line("flash", "texels", view.level_size(0) * entry);
  if (view.levels > 1)
    text += line("flash", "mip levels (" + std::to_string(view.levels - 1) + ")",
                 (view.offset_of(view.levels) - view.level_size(0)) * entry);
  if (!texture.palette.empty()) text += line("flash", "palette", texture.palette.size() * 2);
  text += line("flash", "total", texture.flash_bytes());
  return text + line("ram", "total", 0);
}

}  // namespace spanline::sim
