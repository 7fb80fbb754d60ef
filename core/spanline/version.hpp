#pragma once
/// @file
/// The version of Spanline. This is the one place where it is written: CMake reads these three lines, and `spanline
/// --version` prints what they make. Below 1.0 a new minor version may ask for changes in programs (CHANGELOG.md says
/// which), a new patch never does.
///
/// ```cpp
/// #include <spanline/version.hpp>
///
/// static_assert(SPANLINE_VERSION_MAJOR == 0 && SPANLINE_VERSION_MINOR >= 1, "written for Spanline 0.1");
/// ```

/// Rises where programs must change, from 1.0 on.
#define SPANLINE_VERSION_MAJOR 0
/// Rises with what is new.
#define SPANLINE_VERSION_MINOR 1
/// Rises with what is mended.
#define SPANLINE_VERSION_PATCH 0

#define SPANLINE_TEXT_OF_WORD(word) #word
#define SPANLINE_TEXT_OF(word) SPANLINE_TEXT_OF_WORD(word)

namespace spanline {

/// The same as text: "major.minor.patch".
inline constexpr char version[] = SPANLINE_TEXT_OF(SPANLINE_VERSION_MAJOR) "." SPANLINE_TEXT_OF(
    SPANLINE_VERSION_MINOR) "." SPANLINE_TEXT_OF(SPANLINE_VERSION_PATCH);

}  // namespace spanline

#undef SPANLINE_TEXT_OF
#undef SPANLINE_TEXT_OF_WORD
