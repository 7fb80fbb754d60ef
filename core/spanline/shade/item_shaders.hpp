#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "spanline/raster/link.hpp"
#include "spanline/raster/polygon_corners.hpp"
#include "spanline/raster/span.hpp"
#include "spanline/raster/surface_blocks.hpp"
#include "spanline/shade/shader_list.hpp"

namespace spanline {

/// A shader that writes into an item buffer: each pixel holds the number in the polygon table of the polygon that owns
/// it (deferred shading; lecture 004, "Z-Buffer Pros"). `make` leaves the surface's `item`, this number, to its caller.
struct ItemShader {
  using Pixel = Link;
  static constexpr bool interpolates = false;

  struct Source {
    static constexpr bool constant = true;
    Link item;
    [[nodiscard]] Link get() const { return item; }
    void forward() {}
    void back() {}
  };
  struct Surface {
    Link item;
    void next_row() {}
    void skip_rows(std::int32_t) {}
    [[nodiscard]] Source source(std::int32_t) const { return {item}; }
  };
  template <class Group>
  static void make(Surface&, const Group&, const PolygonCorners&) {}
};

/// An item shader for a shader whose surfaces may have holes. The shader's own sources say which pixels are present.
template <class Shader>
struct ItemShaderWithHoles {
  using Pixel = Link;
  static constexpr bool interpolates = true;

  template <class InnerSource>
  struct Source : InnerSource {
    Link item;
    [[nodiscard]] Link get() const { return item; }
  };
  template <class InnerBlocks>
  struct Blocks : InnerBlocks {
    Link item;
    [[nodiscard]] auto source() const { return Source<decltype(InnerBlocks::source())>{InnerBlocks::source(), item}; }
  };
  struct Surface : Shader::Surface {
    Link item;
    [[nodiscard]] auto blocks(std::int32_t column) const {
      return Blocks<decltype(Shader::Surface::blocks(column))>{Shader::Surface::blocks(column), item};
    }
  };
  template <class Group, class Gradients>
  static void make(Surface& surface, const Group& group, const PolygonCorners& polygon, const Gradients& gradients) {
    Shader::make(surface, group, polygon, gradients);
  }
};

namespace item_shaders {
template <class Shader>
concept HasHoles = SurfaceInBlocks<typename Shader::Surface> && requires(const typename Shader::Surface& surface) {
  { surface.blocks(0).source() } -> SourceWithHoles;
};

/// The list of item shaders `List`, followed by one for each of `Shaders` that has holes.
template <class List, class... Shaders>
struct Joined {
  using Type = List;
};
template <class... Items, class First, class... Rest>
struct Joined<ShaderList<Items...>, First, Rest...> : Joined<ShaderList<Items...>, Rest...> {};
template <class... Items, HasHoles First, class... Rest>
struct Joined<ShaderList<Items...>, First, Rest...>
    : Joined<ShaderList<Items..., ItemShaderWithHoles<First>>, Rest...> {};
}  // namespace item_shaders

/// The item shaders that replace the shaders of a list. They are selected by the same numbers; the number
/// `without_holes` selects the plain one, for groups that have no hole even if their shader could draw some.
template <class... Shaders>
struct ItemShaders : item_shaders::Joined<ShaderList<ItemShader>, Shaders...>::Type {
  using List = typename item_shaders::Joined<ShaderList<ItemShader>, Shaders...>::Type;

  static constexpr std::uint8_t without_holes = sizeof...(Shaders);

  template <class F>
  [[gnu::always_inline]] static inline auto with(std::uint8_t shader, F&& f) {
    if constexpr (List::count == 1)
      return f.template operator()<ItemShader>();
    else
      return List::with(place[shader], std::forward<F>(f));
  }

 private:
  static constexpr auto place = [] {
    std::array<std::uint8_t, sizeof...(Shaders) + 1> table{};
    std::size_t i = 0;
    std::uint8_t with_holes = 0;
    ((table[i++] = item_shaders::HasHoles<Shaders> ? ++with_holes : std::uint8_t{0}), ...);
    return table;
  }();
};

}  // namespace spanline
