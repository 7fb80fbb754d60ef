#include "render/statistics_json.hpp"
#include <spanline/visibility/counters.hpp>

#include <nlohmann/json.hpp>

namespace spanline::sim {

std::string to_json(const FrameStatistics& statistics) {
  using Json = nlohmann::ordered_json;
  const auto known = [](const std::optional<std::uint64_t>& count) { return count ? Json(*count) : Json(nullptr); };
  const PolygonSets& polygons = statistics.polygons;
  Json obscured_by = nullptr;
  if (const auto& by = polygons.obscured_by)
    obscured_by = Json{{"same_object", by->same_object}, {"other_object", by->other_object}, {"both", by->both}};
  Json json;
  json["polygons"] = Json{{"total", polygons.total},
                          {"outside", polygons.outside},
                          {"back", polygons.back},
                          {"empty", polygons.empty},
                          {"obscured", known(polygons.obscured)},
                          {"obscured_by", obscured_by},
                          {"visible", known(polygons.visible)},
                          {"whole", polygons.whole}};
  const VisibilityCounters& visibility = statistics.visibility;
  json["pixels"] = visibility.pixels;
  json["spans"] = visibility.spans;
  json["depth_tests"] = visibility.depth_tests;
  if (!visibility.names.empty()) json["counters"] = Json::object();
  for (std::size_t i = 0; i < visibility.names.size(); ++i)
    json["counters"][std::string(visibility.names[i])] = visibility.own[i];
  json["peak_bytes"] = Json::object();
  for (const auto& [pool, bytes] : statistics.peak_bytes) json["peak_bytes"][pool] = bytes;
  return json.dump(2) + "\n";
}

}  // namespace spanline::sim
