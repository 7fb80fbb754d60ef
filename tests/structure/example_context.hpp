#pragma once
// What examples in the heads of headers may take for granted (examples.py): a renderer with all shaders and the memory
// that it has, the cube of README.md, and somebody who takes finished bands.
#include <cstddef>

#include "spanline/frame/ready_made_traits.hpp"
#include "spanline/frame/renderer.hpp"

extern const spanline::Mesh cube;
inline constexpr spanline::Capacity picture_size{
    .width = 160, .height = 128, .band_lines = 8, .vertices = 8, .polygons = 6, .fans = 6, .active = 6};
extern spanline::Renderer<spanline::GeneralSeeThroughTraits<>> renderer;
bool send(int y0, int y1, std::span<const std::uint16_t> pixels);
