#include "convert/font_writer.hpp"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_SFNT_NAMES_H
#include FT_TRUETYPE_IDS_H

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "base/failure.hpp"
#include "spanline/model/font.hpp"

namespace spanline::sim {
namespace {

constexpr unsigned first_character = 32, last_character = 255;
constexpr std::size_t line_length = 110;

/// FreeType and one face of it, closed in order.
class Face {
 public:
  Face(const std::string& path, int pixels) : path_(path) {
    if (!std::filesystem::is_regular_file(path)) throw file_failure(path, "is no file that can be read");
    FT_Library library = nullptr;
    if (FT_Init_FreeType(&library) != 0) throw Failure("FreeType cannot be started");
    library_.reset(library);
    FT_Face face = nullptr;
    if (FT_New_Face(library, path.c_str(), 0, &face) != 0) throw file_failure(path, "is no font that FreeType knows");
    face_.reset(face);
    if (FT_Set_Pixel_Sizes(face, 0, static_cast<FT_UInt>(pixels)) != 0)
      throw file_failure(path, "has no characters of " + std::to_string(pixels) + " pixels");
  }

  /// The slot with a character's bitmap, 8 bits a pixel; the font's own sign for "missing" where it has none.
  [[nodiscard]] const FT_GlyphSlotRec& draw(unsigned character) const {
    if (FT_Load_Char(face_.get(), character, FT_LOAD_RENDER) != 0)
      throw file_failure(path_, "cannot draw character " + std::to_string(character));
    return *face_->glyph;
  }

  /// A line of the font's table of names in ASCII; empty if there is none.
  [[nodiscard]] std::string name(FT_UShort wanted) const {
    for (FT_UInt i = 0; i < FT_Get_Sfnt_Name_Count(face_.get()); ++i) {
      FT_SfntName entry{};
      if (FT_Get_Sfnt_Name(face_.get(), i, &entry) != 0 || entry.name_id != wanted) continue;
      const bool two_bytes = entry.platform_id != TT_PLATFORM_MACINTOSH;
      std::string text;
      for (FT_UInt k = two_bytes ? 1 : 0; k < entry.string_len; k += two_bytes ? 2 : 1) {
        const auto c = static_cast<char>(entry.string[k]);
        text += c == '\r' ? '\n' : (c >= ' ' && c < 127) || c == '\n' ? c : ' ';
      }
      return text;
    }
    return {};
  }
  [[nodiscard]] const FT_Size_Metrics& metrics() const { return face_->size->metrics; }

 private:
  const std::string& path_;
  std::unique_ptr<FT_LibraryRec_, decltype(&FT_Done_FreeType)> library_{nullptr, FT_Done_FreeType};
  std::unique_ptr<FT_FaceRec_, decltype(&FT_Done_Face)> face_{nullptr, FT_Done_Face};
};

/// Text as a block of // comments, broken between words.
void append_comment(std::string& header, const std::string& text) {
  std::string line = "//", word;
  const auto end_line = [&] {
    header += line + "\n";
    line = "//";
  };
  const auto end_word = [&] {
    if (word.empty()) return;
    if (line.size() + 1 + word.size() > line_length) end_line();
    line += " " + word;
    word.clear();
  };
  for (const char c : text + "\n") {
    if (c == ' ' || c == '\n') {
      end_word();
      if (c == '\n') end_line();
    } else {
      word += c;
    }
  }
}

template <class Item>
void append_list(std::string& header, const std::vector<Item>& items) {
  std::string line;
  for (const Item& item : items) {
    const std::string text = item + ",";
    if (line.size() + text.size() > line_length) {
      header += line + "\n";
      line.clear();
    }
    line += text;
  }
  header += line + "};\n";
}

int pixels_up(FT_Pos sixty_fourths) { return static_cast<int>((sixty_fourths + 63) >> 6); }

}  // namespace

std::string write_font_header(const std::string& path, int pixels, const std::string& name) {
  const Face face(path, pixels);
  std::vector<std::string> glyphs, coverage;
  std::size_t values = 0;
  unsigned half = 0;
  for (unsigned character = first_character; character <= last_character; ++character) {
    const FT_GlyphSlotRec& slot = face.draw(character);
    const FT_Bitmap& bitmap = slot.bitmap;
    if (bitmap.width > 255 || bitmap.rows > 255 || values > 65535)
      throw file_failure(path, "is too large at " + std::to_string(pixels) + " pixels");
    glyphs.push_back("{" + std::to_string(values) + "," + std::to_string(bitmap.width) + "," +
                     std::to_string(bitmap.rows) + "," + std::to_string(slot.bitmap_left) + "," +
                     std::to_string(slot.bitmap_top) + "," + std::to_string((slot.advance.x + 32) >> 6) + "}");
    for (unsigned row = 0; row < bitmap.rows; ++row)
      for (unsigned column = 0; column < bitmap.width; ++column) {
        const unsigned value =
            (bitmap.buffer[static_cast<int>(row) * bitmap.pitch + static_cast<int>(column)] * 15u + 127) / 255;
        if (values++ % 2 == 0)
          half = value;
        else
          coverage.push_back(std::to_string(value << 4 | half));
      }
  }
  if (values % 2 != 0) coverage.push_back(std::to_string(half));

  std::string header = "// Written by spanline font from " + std::filesystem::path(path).filename().string() + " at " +
                       std::to_string(pixels) + " pixels.\n//\n";
  append_comment(header, face.name(TT_NAME_ID_COPYRIGHT));
  append_comment(header, face.name(TT_NAME_ID_LICENSE));
  header += "#pragma once\n#include <spanline/model/font.hpp>\n\nnamespace spanline_fonts {\n\n";
  header += "inline constexpr spanline::Glyph " + name + "_glyphs[] = {\n";
  append_list(header, glyphs);
  header += "inline constexpr unsigned char " + name + "_coverage[] = {\n";
  append_list(header, coverage);
  header += "inline constexpr spanline::Font " + name + "{.glyphs = " + name + "_glyphs, .coverage = " + name +
            "_coverage,\n  .first_character = " + std::to_string(first_character) +
            ", .ascent = " + std::to_string(pixels_up(face.metrics().ascender)) +
            ", .descent = " + std::to_string(pixels_up(-face.metrics().descender)) +
            ", .line_height = " + std::to_string(pixels_up(face.metrics().height)) + "};\n";
  header += "\n}  // namespace spanline_fonts\n";
  return header;
}

}  // namespace spanline::sim
