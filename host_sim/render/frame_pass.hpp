#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/frame.hpp"
#include "spanline/frame/renderer.hpp"
#include "spanline/visibility/registry.hpp"

namespace spanline::sim {

/// What a pass over a frame is drawn from.
struct PassInput {
  const std::vector<Mesh>& meshes;
  const std::vector<Material>& materials;  ///< one a mesh
  const FrameSettings& settings;           ///< whose lights outlive the pass
  std::size_t triangles;                   ///< of all meshes
  int depth_bits;                          ///< 16 or 24
  DepthSense depth_sense;
  Capacity& capacity;              ///< grows where a pool is too small
  std::vector<std::byte>& memory;  ///< grows with it
  bool want_depth = false, want_covered = false;
};

/// What came out. Tables that were not asked for are empty.
template <class Pixel>
struct PassOutput {
  std::vector<Pixel> pixels;
  std::vector<std::uint32_t> depths;
  std::vector<bool> covered;  ///< by triangle: whether it covers a pixel centre
  Statistics statistics{};
  PoolPeaks peaks{};
};

/// Makes room for what a frame wanted, and a little more so that frames of a turntable rarely ask again. Throws Failure
/// if no pool was at fault.
void grow(Capacity& capacity, const Status& status);

/// One visibility algorithm at work.
struct AlgorithmPasses {
  PassOutput<std::uint16_t> (*colours)(const PassInput&);
  PassOutput<std::uint32_t> (*ids)(const PassInput&);
  PickedPixel (*pick)(const PassInput&, int x, int y);
};

/// Each in a translation unit of its own, which the build makes of algorithm_passes.cpp.in.
template <AlgorithmId Unit>
[[nodiscard]] AlgorithmPasses algorithm_passes();
#define SPANLINE_ALGORITHM(id, ...) \
  template <>                       \
  AlgorithmPasses algorithm_passes<AlgorithmId::id>();
#include "spanline/visibility/algorithms.def"

}  // namespace spanline::sim
