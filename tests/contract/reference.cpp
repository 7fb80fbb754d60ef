// The z-buffer of the whole picture, without the bounds that the registry's has.
#include "drawer_by.hpp"

namespace spanline::contract {

Drawing reference(const Scene& scene, Manner manner) { return draw_by<ZBuffer>(scene, manner_for_reference(manner)); }

}  // namespace spanline::contract
