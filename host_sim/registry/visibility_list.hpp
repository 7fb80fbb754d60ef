#pragma once
#include <string_view>
#include <tuple>
#include <utility>

#include "registry/registry.hpp"
#include "spanline/frame/traits.hpp"
#include "spanline/visibility/span/spanning_scan_line.hpp"

namespace spanline::sim {

/// An entry and the visibility of the renderers that draw it.
template <class VisibilityT>
struct VisibilityLine {
  using Visibility = VisibilityT;
  VisibilityEntry entry;
};

/// Every visibility algorithm that there is: to add one is to add a line. The command line, the viewer and the contract
/// suite (tests/contract) take them from here.
inline constexpr std::tuple visibility_list{
    VisibilityLine<BoundedZBuffer>{{"zbuffer", "exact", "depth buffer of the whole picture", true, 16}},
    VisibilityLine<BoundedZBuffer>{
        {"scanline-z", "exact", "depth buffer of one band of lines, polygons sorted by bands", false, 16}},
    VisibilityLine<Spanning>{
        {"span", "exact", "spanning scan line: no depth buffer, one decision a span, every pixel once", false, 24}},
};

/// Calls f.template operator()<Visibility>() for the algorithm of an entry. F's result is the same for all.
template <class F>
auto with_visibility(const VisibilityEntry& entry, F&& f) {
  using Result = decltype(f.template operator()<ZBuffer>());
  Result result{};
  const auto try_line = [&]<class Visibility>(const VisibilityLine<Visibility>& line) {
    if (std::string_view(line.entry.name) != entry.name) return false;
    result = f.template operator()<Visibility>();
    return true;
  };
  std::apply([&](const auto&... lines) { (void)(try_line(lines) || ...); }, visibility_list);
  return result;
}

}  // namespace spanline::sim
