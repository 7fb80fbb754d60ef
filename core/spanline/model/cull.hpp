#pragma once
/// @file
/// Which side of polygons is drawn.
///
/// ```cpp
/// #include <spanline/frame/frame_settings.hpp>
///
/// FrameSettings settings;
/// settings.cull = Cull::none;  // sheets that are seen from both sides
/// ```
#include <cstdint>

namespace spanline {

/// Which polygons are not drawn, by the sign of their area on screen. Front faces are counter-clockwise.
enum class Cull : std::uint8_t {
  back,   ///< back faces
  front,  ///< front faces
  none,   ///< none
};

}  // namespace spanline
