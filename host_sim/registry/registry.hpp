#pragma once
#include <span>
#include <string>
#include <vector>

#include "spanline/model/material.hpp"

namespace spanline::sim {

/// A visibility algorithm that `--visibility` names; visibility_list.hpp has them.
struct VisibilityEntry {
  const char* name;
  const char* exactness;  ///< exact, near-exact or order-bound
  const char* description;
  bool full_frame;  ///< works on the whole picture at once, whatever --band says
  int depth_bits;   ///< where --depth does not say
};

/// A way of shading that `--shade` names.
struct ShadingEntry {
  const char* name;
  const char* description;
  bool smooth;    ///< interpolates light and colour between vertices
  bool lit;       ///< by lights; otherwise fully bright
  bool textured;  ///< by the model's textures, or the one that --texture names
};

/// A line of `spanline list`.
struct ListEntry {
  std::string kind, name, exactness, description;
};

[[nodiscard]] std::span<const VisibilityEntry> visibility_algorithms();
[[nodiscard]] std::span<const ShadingEntry> shadings();

/// The entry of that name. Throws NotAvailable for a name that a later version brings and UsageError for others.
[[nodiscard]] const VisibilityEntry& find_visibility(const std::string& name);
[[nodiscard]] const ShadingEntry& find_shading(const std::string& name);

/// All that there is: visibility algorithms, shadings, panels and boards.
[[nodiscard]] std::vector<ListEntry> list_entries();

}  // namespace spanline::sim
