#pragma once
#include <string>

namespace spanline::sim {

/// Rasterises the characters 32 … 255 of a font file (TrueType, OpenType and what else FreeType reads) at `pixels` an
/// em, and writes them as a header for flash: a `Font` called `name` in namespace spanline_fonts. The font's own
/// copyright and licence stand at the head of it. Throws Failure that names the file and what is wrong with it.
[[nodiscard]] std::string write_font_header(const std::string& path, int pixels, const std::string& name);

}  // namespace spanline::sim
