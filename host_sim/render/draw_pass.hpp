#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/failure.hpp"
#include "render/frame_pass.hpp"
#include "render/refusal_text.hpp"
#include "spanline/frame/pick.hpp"
#include "spanline/frame/ready_made_traits.hpp"

namespace spanline::sim {

/// Gathers the bands of a frame.
template <class Traits>
struct FrameSink {
  using Pixel = typename Traits::Format::Pixel;
  using Depth = typename Traits::Depth;

  PassOutput<Pixel>& output;
  bool want_depth;

  template <class Band>
  bool operator()(const Band& band) {
    output.pixels.insert(output.pixels.end(), band.pixels.begin(), band.pixels.end());
    if (!want_depth) return true;
    for (const typename Depth::Word word : band.depth)
      output.depths.push_back(word == Depth::clear ? background_depth(Depth::bits) : Depth::integer(word));
    return true;
  }

  void covered(std::uint32_t triangle) {
    if (!output.covered.empty()) output.covered[triangle] = true;
  }
};

/// Submits the frame to a renderer of those traits and finishes it by `finish(renderer)`, which returns a Status.
template <class Traits, class Finish>
Status attempt_pass(const PassInput& input, Finish& finish) {
  const std::size_t bytes = Renderer<Traits>::bytes_needed(input.capacity);
  if (input.memory.size() < bytes) input.memory.resize(bytes);
  Renderer<Traits> renderer(input.capacity, std::span(input.memory).first(bytes));
  if (const Status status = renderer.status(); !status.ok()) return status;
  if (const Status status = renderer.begin(input.settings); !status.ok()) return status;
  for (std::size_t i = 0; i < input.meshes.size(); ++i)
    if (const Status status = renderer.add(input.meshes[i], Transform{}, input.materials[i]); !status.ok())
      return status;
  return finish(renderer);
}

/// The same, as often as it takes until every pool is large enough.
template <class Traits, class Finish>
void finish_pass(const PassInput& input, Finish finish) {
  for (;;) {
    const Status status = attempt_pass<Traits>(input, finish);
    if (status.ok()) return;
    if (status.fault != Fault::pool_full) throw Failure(refusal_text(status));
    grow(input.capacity, status);
  }
}

/// The whole frame.
template <class Traits>
PassOutput<typename Traits::Format::Pixel> draw_pass(const PassInput& input) {
  PassOutput<typename Traits::Format::Pixel> output;
  finish_pass<Traits>(input, [&](Renderer<Traits>& renderer) {
    output.pixels.clear();
    output.depths.clear();
    output.covered.assign(input.want_covered ? input.triangles : 0, false);
    const Status status = renderer.draw(FrameSink<Traits>{output, input.want_depth});
    output.statistics = renderer.statistics();
    output.peaks = renderer.peaks();
    return status;
  });
  return output;
}

/// f(depth format) for the one that is asked for.
template <class F>
auto with_depth(const PassInput& input, F f) {
  constexpr auto smaller = DepthSense::smaller_is_nearer, larger = DepthSense::larger_is_nearer;
  const bool smaller_wanted = input.depth_sense == smaller;
  if (input.depth_bits == 16) return smaller_wanted ? f(Depth16<smaller>{}) : f(Depth16<larger>{});
  return smaller_wanted ? f(Depth24<smaller>{}) : f(Depth24<larger>{});
}

/// Colours by one list of shaders for everything that a model may have; ids and picks by one of their own.
template <class Visibility, AlgorithmId Unit>
AlgorithmPasses passes_by() {
  static_assert(BandDrawer<IdTraits<Visibility>>::Visibility::needs == entry_of(Unit).needs,
                "the registry's line and the algorithm differ in what it needs");
  return {
      [](const PassInput& input) {
        return with_depth(input, [&]<class Depth>(Depth) {
          return draw_pass<GeneralSeeThroughTraits<Rgb565, Depth, Counted, Visibility>>(input);
        });
      },
      [](const PassInput& input) {
        return with_depth(input,
                          [&]<class Depth>(Depth) { return draw_pass<IdTraits<Depth, Counted, Visibility>>(input); });
      },
      [](const PassInput& input, int x, int y) {
        return with_depth(input, [&]<class Depth>(Depth) {
          Picked<Depth> picked;
          finish_pass<IdTraits<Depth, Counted, Visibility>>(
              input, [&](auto& renderer) { return spanline::pick(renderer, x, y, picked); });
          return PickedPixel{picked.id, picked.id == 0 ? background_depth(Depth::bits) : picked.depth};
        });
      },
  };
}

}  // namespace spanline::sim
