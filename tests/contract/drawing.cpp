#include "drawing.hpp"
#include <spanline/frame/ready_made_traits.hpp>

#include <stdexcept>
#include <string_view>
#include <tuple>

#include "draw_with.hpp"
#include "registry/visibility_list.hpp"

namespace spanline::contract {
namespace {

/// Flat shading, opaque and see-through.
template <class Depth, class Visibility>
using LayerTraits = RendererTraits<Rgb565, ShaderList<FlatShader<Rgb565>, SeeThroughShader<Rgb565, FlatShader<Rgb565>>>,
                                   Depth, Visibility>;

template <class Visibility, DepthSense Sense>
Drawing draw_in(const Scene& scene, const Manner& manner) {
  if (manner.content == Manner::Content::ids)
    return draw_with<IdTraits<Depth24<Sense>, Counted, Visibility>>(scene, manner);
  if (manner.content == Manner::Content::layers)
    return draw_with<LayerTraits<Depth24<Sense>, Visibility>>(scene, manner);
  return draw_with<GouraudTraits<Rgb565, Depth24<Sense>, Visibility>>(scene, manner);
}

template <class Visibility>
Drawing draw_by(const Scene& scene, const Manner& manner) {
  return manner.sense == DepthSense::smaller_is_nearer
             ? draw_in<Visibility, DepthSense::smaller_is_nearer>(scene, manner)
             : draw_in<Visibility, DepthSense::larger_is_nearer>(scene, manner);
}

}  // namespace

const std::vector<sim::VisibilityEntry>& algorithms() {
  static const auto entries = std::apply(
      [](const auto&... lines) { return std::vector<sim::VisibilityEntry>{lines.entry...}; }, sim::visibility_list);
  return entries;
}

const sim::VisibilityEntry& algorithm(const char* name) {
  for (const sim::VisibilityEntry& entry : algorithms())
    if (std::string_view(entry.name) == name) return entry;
  throw std::logic_error("no such algorithm");
}

Drawing draw(const sim::VisibilityEntry& algorithm, const Scene& scene, const Manner& manner) {
  const Manner own = manner_for(algorithm, manner);
  return sim::with_visibility(algorithm, [&]<class Visibility>() { return draw_by<Visibility>(scene, own); });
}

Drawing reference(const Scene& scene, Manner manner) { return draw_by<ZBuffer>(scene, manner_for_reference(manner)); }

Drawing draw_16_bits(const sim::VisibilityEntry& algorithm, const Scene& scene) {
  Manner manner;
  if (!algorithm.full_frame) manner.band_lines = 16;
  return sim::with_visibility(algorithm, [&]<class Visibility>() {
    return draw_with<IdTraits<Depth16<>, Counted, Visibility>>(scene, manner);
  });
}

}  // namespace spanline::contract
