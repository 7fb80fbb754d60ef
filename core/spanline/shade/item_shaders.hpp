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

/// Shaders that write into an item buffer: each pixel holds the number of the polygon that owns it in the polygon table
/// (lecture 004, "Deferred Shading"). `item` of their surfaces is that number; whoever makes one fills it in.
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

/// The same for a shader whose surfaces may have holes: its own sources tell where.
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

/// A list of item shaders, the plain one first, to which those of `Shaders` that have holes are added.
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

/// The item shaders in the place of a list's own, by the same numbers; and for groups without any hole, whatever their
/// shader could draw.
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
