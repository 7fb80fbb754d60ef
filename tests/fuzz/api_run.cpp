#include "api_run.hpp"

#include <algorithm>

#include "api_drawing.hpp"

namespace spanline::fuzz {
namespace {

/// What was left out may depend on the band height, where these pools are full or the sink gives up.
bool is_whole(const Outcome& outcome) { return outcome.drawn().ok(); }

/// Whole pictures of renderers that draw alike are equal, and so are the statuses of what was added.
std::string difference(const std::vector<Drawn>& all) {
  const auto first = std::find_if(all.begin(), all.end(), [](const Drawn& d) { return is_whole(d.outcome); });
  for (const Drawn& other : all)
    if (is_whole(other.outcome) && !(other.outcome == first->outcome)) return other.name + " is not " + first->name;
  return {};
}

}  // namespace

std::string fault_in(const ApiFrame& frame, Statuses& told) {
  std::string fault;
  for (const auto draw :
       {draw_everything, draw_plain, draw_opaque, draw_world, draw_ids, draw_in_order, draw_ids_in_order}) {
    const Run run = draw(frame);
    if (fault.empty()) fault = run.fault;
    if (fault.empty()) fault = difference(run.all);
    told.insert(told.end(), run.told.begin(), run.told.end());
    for (const Drawn& drawn : run.all)
      told.insert(told.end(), drawn.outcome.statuses.begin(), drawn.outcome.statuses.end());
  }
  return fault;
}

}  // namespace spanline::fuzz
