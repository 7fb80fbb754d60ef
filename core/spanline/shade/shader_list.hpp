#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <new>
#include <type_traits>

#include "spanline/shade/fill_run.hpp"

namespace spanline {

template <class... Shaders>
struct ItemShaders;

namespace shader_list {
/// The layer type of the first see-through shader; an empty type if the list has none.
template <class... Shaders>
struct LayerOf {
  struct Type {};
};
template <class First, class... Rest>
struct LayerOf<First, Rest...> : LayerOf<Rest...> {};
template <SeeThrough First, class... Rest>
struct LayerOf<First, Rest...> {
  using Type = typename First::Layer;
};
}  // namespace shader_list

/// The shaders that a renderer links. A polygon's surface is stored in bytes that fit the largest surface. A list of
/// one shader selects it without any code.
template <class... Shaders>
struct ShaderList {
  static constexpr std::size_t count = sizeof...(Shaders);
  static_assert(count > 0);
  /// Whether any of the shaders is see-through.
  static constexpr bool see_through = (SeeThrough<Shaders> || ...);
  /// Whether making a surface takes more than copying colours, for any of the shaders.
  static constexpr bool interpolates = (Shaders::interpolates || ...);
  using Layer = typename shader_list::LayerOf<Shaders...>::Type;
  /// The item shaders that replace these shaders (item_shaders.hpp).
  using Items = ItemShaders<Shaders...>;

  struct Surface {
    alignas(std::max(
        {alignof(typename Shaders::Surface)...})) std::byte bytes[std::max({sizeof(typename Shaders::Surface)...})];
    template <class S>
    [[nodiscard]] S& as() {
      return *std::launder(reinterpret_cast<S*>(bytes));
    }
  };

  /// Fills a run of visible pixels, for algorithms that work in spans: `length` pixels of a surface from `column` on,
  /// or of one value.
  template <class S, class Pixel>
  static void fill(const S& surface, std::int32_t column, std::uint32_t length, Pixel* pixels) {
    fill_run(surface, column, length, pixels);
  }
  template <class Pixel>
  [[gnu::noinline]] static void fill_apart(Pixel value, std::uint32_t length, Pixel* pixels) {
    fill_constant(value, length, pixels);
  }

  /// Index of a shader in the list; `count` if it is not there.
  template <class Shader>
  static constexpr std::uint8_t index_of = [] {
    std::uint8_t i = 0;
    const bool found = ((std::is_same_v<Shader, Shaders> || (++i, false)) || ...);
    return found ? i : static_cast<std::uint8_t>(count);
  }();

  /// Index of the first shader for which f.template operator()<Shader>() is true; `count` if there is none.
  template <class F>
  [[nodiscard]] static constexpr std::uint8_t first(F&& f) {
    std::uint8_t i = 0;
    const bool found = ((f.template operator()<Shaders>() || (++i, false)) || ...);
    return found ? i : static_cast<std::uint8_t>(count);
  }

  /// Calls f.template operator()<Shader>() for the shader at `index`.
  template <class F>
  [[gnu::always_inline]] static inline auto with(std::uint8_t index, F&& f) {
    return with_from<F, Shaders...>(index, f);
  }

 private:
  template <class F, class First, class... Rest>
  [[gnu::always_inline]] static inline auto with_from(std::uint8_t index, F& f) {
    if constexpr (sizeof...(Rest) == 0)
      return f.template operator()<First>();
    else
      return index == 0 ? f.template operator()<First>()
                        : with_from<F, Rest...>(static_cast<std::uint8_t>(index - 1), f);
  }
};

namespace shader_list {
template <class List, class... More>
struct Longer;
template <class... Shaders, class... More>
struct Longer<ShaderList<Shaders...>, More...> {
  using type = ShaderList<Shaders..., More...>;
};
}  // namespace shader_list

/// The list of shaders `List`, followed by `More`.
template <class List, class... More>
using WithShaders = typename shader_list::Longer<List, More...>::type;

}  // namespace spanline
