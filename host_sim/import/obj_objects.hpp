#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace spanline::sim {

/// The object of each triangle of an OBJ file, in file order, where a face of n corners has n − 2 triangles. Objects
/// are what `o` lines name: equal names are one object, and faces before the first `o` are another. Groups (`g`) are
/// parts of an object. Empty if all triangles are of one object.
///
/// It counts the corners that faces state. A file whose faces the importer understands differently has another number
/// of triangles.
[[nodiscard]] std::vector<std::uint32_t> objects_of_obj(const std::string& content);

}  // namespace spanline::sim
