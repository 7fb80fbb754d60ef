// Compiled, not run, for a 32-bit board: what `convert` says of RAM must be what the renderer takes there.
#include "convert/board_sizes.hpp"
#include "spanline/frame/ready_made_traits.hpp"
#include "spanline/frame/renderer.hpp"
#include "spanline/model/mesh.hpp"

namespace spanline::sim::board {

using Board = Renderer<GouraudTraits<>>;

constexpr std::size_t bytes_of_eight(std::uint32_t Capacity::*pool) {
  Capacity more;
  more.*pool += 8;
  return Board::bytes_needed(more) - Board::bytes_needed(Capacity{});
}

static_assert(bytes_of_eight(&Capacity::instances) == 8 * instance);
static_assert(bytes_of_eight(&Capacity::vertices) == 8 * vertex);
static_assert(bytes_of_eight(&Capacity::shades) == 8 * shade);
static_assert(bytes_of_eight(&Capacity::polygons) == 8 * polygon);
static_assert(bytes_of_eight(&Capacity::fans) == 8 * fan);
static_assert(bytes_of_eight(&Capacity::active) == 8 * active);
static_assert(Board::bytes_needed(Capacity{.instances = 0}) == bands_of_16);
static_assert(sizeof(Mesh) == mesh_object);

}  // namespace spanline::sim::board
