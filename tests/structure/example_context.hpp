#pragma once
// What examples in the heads of headers may take for granted (examples.py): a renderer with all shaders, and somebody
// who takes finished bands.
#include <cstdint>
#include <span>

#include "spanline/frame/ready_made_traits.hpp"
#include "spanline/frame/renderer.hpp"

extern spanline::Renderer<spanline::GeneralSeeThroughTraits<>> renderer;
bool send(int y0, int y1, std::span<const std::uint16_t> pixels);
