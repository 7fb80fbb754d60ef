#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "scenes/model_view.hpp"
#include "spanline/frame/renderer.hpp"
#include "spanline/hal/display_sink.hpp"
#include "spanline/hal/pixel_order.hpp"

namespace spanline::apps {

/// A model that turns on a display: each frame is drawn in bands, one of which is on its way to the panel while the
/// next is drawn. Pixels lie in the panel's order from the start.
///
/// Where the board has a Filler, that clears a band while the one above it is drawn.
///
/// A bus that stops answering costs the frame under way; the next one initialises the panel anew. Everything lies in
/// the caller's memory.
template <hal::Panel PanelType, hal::Clock ClockType, ShadingMode shading = ShadingMode::gouraud,
          class FillerType = hal::NoFiller>
class Turntable {
 public:
  using Format = std::conditional_t<PanelType::pixel_order == hal::PixelOrder::native, Rgb565, Rgb565Swapped>;
  using Shader = std::conditional_t<shading == ShadingMode::flat, FlatShader<Format>, GouraudShader<Format>>;
  using Traits = RendererTraits<Format, ShaderList<Shader>>;
  using Picture = Renderer<Traits>;

  /// Frames of a whole turn. The fifth after the start is the view of the benchmark scenes S4 and S5.
  static constexpr std::uint32_t frames_a_turn = 60;

  /// How one frame went: what the display and the renderer had to say.
  struct Result {
    hal::DisplayStatus display = hal::DisplayStatus::ok;
    Status drawing{};
    [[nodiscard]] constexpr bool ok() const { return display == hal::DisplayStatus::ok && drawing.ok(); }
  };

  /// What the picture of a mesh takes: `polygons` that face the eye at most, `active` of them across a band's edge.
  [[nodiscard]] static constexpr Capacity capacity(const Mesh& mesh, std::uint16_t band_lines,
                                                   std::uint8_t colour_bands, std::uint32_t polygons,
                                                   std::uint32_t active, std::uint8_t depth_bands = 1) {
    const auto vertices = static_cast<std::uint32_t>(mesh.vertex_count());
    return {.width = PanelType::width,
            .height = PanelType::height,
            .band_lines = band_lines,
            .colour_bands = colour_bands,
            .depth_bands = depth_bands,
            .vertices = vertices,
            .shades = shading == ShadingMode::gouraud ? vertices : 0,
            .polygons = polygons,
            .active = active};
  }

  /// `memory` has Picture::bytes_needed(capacity) bytes, in RAM that the bus reaches. Mesh and memory must stay.
  Turntable(PanelType& panel, ClockType& clock, const Mesh& mesh, const Capacity& capacity, std::span<std::byte> memory)
      : mesh_(mesh), box_(scenes::MeshBox::of(mesh)), renderer_(capacity, memory), display_(panel, clock, renderer_) {}

  /// Draws frame `number` of the turn and waits until it is shown.
  Result show(std::uint32_t number) {
    return result_of(display_.show([&](Display& display) { return draw(number, display); }));
  }

  /// The same without waiting: the next frame begins while the last bands are on their way.
  Result show_and_go_on(std::uint32_t number) {
    return result_of(display_.show_and_go_on([&](Display& display) { return draw(number, display); }));
  }

  [[nodiscard]] const hal::PresentStatistics& statistics() const { return display_.present().statistics(); }

 private:
  using Display = hal::DisplaySink<PanelType, ClockType, FillerType>;

  static Result result_of(const hal::ShownFrame<Status>& frame) {
    Result result{frame.display, frame.drawing};
    // Where a sink fails and the display has nothing to say, it was the filler.
    if (result.drawing.fault == Fault::sink_failed && result.display != hal::DisplayStatus::ok) result.drawing = {};
    return result;
  }

  Status draw(std::uint32_t number, Display& display) {
    const Status submitted = submit(number, display);
    const Status drawn = renderer_.draw(display);
    return submitted.ok() ? drawn : submitted;
  }

  Status submit(std::uint32_t number, Display& display) {
    const Angle angle = Angle::from_turns(number % frames_a_turn, frames_a_turn);
    const scenes::ModelView view = scenes::model_view(mesh_, box_, angle, PanelType::height, shading);
    if (const Status begun = renderer_.begin(view.settings); !begun.ok()) return begun;
    // A sink that gives up will do so for drawing, too.
    if constexpr (hal::Filler<FillerType>) static_cast<void>(renderer_.clear_ahead(display));
    return renderer_.add(mesh_, view.transform, view.material);
  }

  const Mesh& mesh_;
  scenes::MeshBox box_;
  Picture renderer_;
  Display display_;
};

}  // namespace spanline::apps
