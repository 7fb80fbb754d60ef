#pragma once
#include <span>
#include <string>
#include <vector>

#include "spanline/model/material.hpp"
#include "spanline/visibility/registry.hpp"

namespace spanline::sim {

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

/// What `--visibility` names: the registry of the core (spanline/visibility/algorithms.def).
[[nodiscard]] std::span<const AlgorithmEntry> visibility_algorithms();
[[nodiscard]] std::span<const ShadingEntry> shadings();

/// The entry of that name. Throws NotAvailable for a name that a later version brings and UsageError for others.
[[nodiscard]] const AlgorithmEntry& find_visibility(const std::string& name);
[[nodiscard]] const ShadingEntry& find_shading(const std::string& name);

/// All that there is: visibility algorithms, shadings, panels and boards.
[[nodiscard]] std::vector<ListEntry> list_entries();

}  // namespace spanline::sim
