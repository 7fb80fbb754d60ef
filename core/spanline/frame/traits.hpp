#pragma once
/// @file
/// What renderers are made of.
///
/// ```cpp
/// #include <spanline/frame/renderer.hpp>
/// #include <spanline/pixel/pixel_format.hpp>
/// #include <spanline/shade/light/flat.hpp>
/// #include <spanline/visibility/span/spanning_scan_line.hpp>
///
/// using Shaders = ShaderList<FlatShader<Rgb565>>;
/// using Plain = Renderer<RendererTraits<Rgb565, Shaders>>;  // a z-buffer of 16 bits
/// using Spans = Renderer<RendererTraits<Rgb565, Shaders, Depth24<>, Spanning>>;
/// ```
#include <concepts>
#include <cstddef>
#include <cstdint>

#include "spanline/raster/depth_format.hpp"
#include "spanline/visibility/zbuffer/depth_buffer.hpp"

namespace spanline {

/// An option of renderer traits: spans, pixels and depth tests are counted, and the sink is told of every triangle that
/// covers a pixel centre. It is an option because counting takes time.
struct Counted {};

/// A format of depths: `Depth16<…>` or `Depth24<…>`.
template <class Option>
concept DepthOption = requires(std::uint32_t plane_word, typename Option::Word kept) {
  { Option::bits } -> std::convertible_to<int>;
  { Option::clear } -> std::convertible_to<typename Option::Word>;
  { Option::hides(plane_word, kept) } -> std::same_as<bool>;
};

namespace traits_options {
template <template <class, class, class, bool> class>
struct AnAlgorithm;
}  // namespace traits_options

/// A choice of visibility algorithm, by its member template `Algorithm<Depth, Pixel, Shaders, counts>`:
/// `ZBuffer`, `BoundedZBuffer`, `Deferred<…>`, `Spanning`, `Painter` or `DepthSort`.
template <class Option>
concept VisibilityOption = requires {
  typename traits_options::AnAlgorithm<Option::template Algorithm>;
};

namespace traits_options {

template <class Option>
inline constexpr bool is_counted = std::same_as<Option, Counted>;

/// The first depth format among the options, or the default.
template <class Default, class... Options>
struct DepthOf {
  using Type = Default;
};
template <class Default, class First, class... Rest>
struct DepthOf<Default, First, Rest...> : DepthOf<Default, Rest...> {};
template <class Default, DepthOption First, class... Rest>
struct DepthOf<Default, First, Rest...> {
  using Type = First;
};

/// The first visibility algorithm among the options, or the default.
template <class Default, class... Options>
struct VisibilityOf {
  using Type = Default;
};
template <class Default, class First, class... Rest>
struct VisibilityOf<Default, First, Rest...> : VisibilityOf<Default, Rest...> {};
template <class Default, VisibilityOption First, class... Rest>
struct VisibilityOf<Default, First, Rest...> {
  using Type = First;
};

/// The choices that a list of options makes. The order of options does not change the type.
template <class... Options>
struct Chosen {
  static_assert(((DepthOption<Options> || VisibilityOption<Options> || is_counted<Options>)&&...),
                "an option of renderer traits is a depth format (Depth16<>, Depth24<>), a visibility algorithm "
                "(ZBuffer, BoundedZBuffer, Deferred<>, Spanning, Painter, DepthSort) or Counted");
  static_assert((std::size_t{0} + ... + std::size_t{DepthOption<Options>}) <= 1,
                "renderer traits take one depth format, and these name two");
  static_assert((std::size_t{0} + ... + std::size_t{VisibilityOption<Options>}) <= 1,
                "renderer traits take one visibility algorithm, and these name two");
  static_assert((std::size_t{0} + ... + std::size_t{is_counted<Options>}) <= 1, "renderer traits name Counted twice");

  using Depth = typename DepthOf<Depth16<>, Options...>::Type;
  using Visibility = typename VisibilityOf<ZBuffer, Options...>::Type;
  static constexpr bool counted = (is_counted<Options> || ...);
};

/// The parts of a renderer, one template parameter for each choice.
template <class PixelFormat, class ShaderListT, class DepthFormatT, class VisibilityT, bool IsCounted>
struct Traits {
  using Format = PixelFormat;                    ///< Rgb565, Rgb565Swapped or PolygonIds
  using Shaders = ShaderListT;                   ///< a ShaderList
  using Depth = DepthFormatT;                    ///< a DepthOption
  using Visibility = VisibilityT;                ///< a VisibilityOption
  static constexpr bool statistics = IsCounted;  ///< whether Counted is among the options
};

}  // namespace traits_options

/// The parts of a renderer, chosen at compile time: a pixel format, a list of shaders, and options in any order, each
/// at most once. A program links only the parts that its traits name.
///
///     RendererTraits<Rgb565, ShaderList<FlatShader<Rgb565>>>                       // Depth16<> and ZBuffer
///     RendererTraits<Rgb565, ShaderList<FlatShader<Rgb565>>, Depth24<>, Spanning>
///
/// Lists of shaders that most programs want have names of their own (frame/ready_made_traits.hpp).
template <class Format, class Shaders, class... Options>
using RendererTraits = traits_options::Traits<Format, Shaders, typename traits_options::Chosen<Options...>::Depth,
                                              typename traits_options::Chosen<Options...>::Visibility,
                                              traits_options::Chosen<Options...>::counted>;

}  // namespace spanline
