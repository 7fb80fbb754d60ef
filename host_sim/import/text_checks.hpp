#pragma once
#include <string>

#include "import/model_format.hpp"

namespace spanline::sim {

/// Finds files that were cut off where the importer would read on as if nothing was missing. Throws std::runtime_error.
void check_complete(ModelFormat format, const std::string& content);

/// Blanks the `o` and `g` lines of an OBJ file: the importer gathers faces by these names, and file order would be lost
/// where a name comes twice. What they say of objects is read before (import/obj_objects.hpp).
void blank_obj_groups(std::string& content);

}  // namespace spanline::sim
