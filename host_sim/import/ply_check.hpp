#pragma once
#include <string>

namespace spanline::sim {

/// Walks through a PLY file as its header describes it and throws std::runtime_error where the header is broken or the
/// body ends too early: the importer would draw what there is.
void check_ply(const std::string& content);

}  // namespace spanline::sim
