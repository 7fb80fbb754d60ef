#pragma once
#include <cstdint>
#include <span>

#include "spanline/raster/band_of_row.hpp"
#include "spanline/raster/link.hpp"
#include "spanline/raster/polygon_table.hpp"

namespace spanline {

/// Calls visit(number, group) for the polygons of a table, the last first.
template <class Visit>
[[gnu::always_inline]] inline void for_each_from_the_last(const PolygonTable& table, Visit visit) {
  for (Link group = table.group_count; group-- > 0;) {
    const std::uint32_t first = table.groups[group].first;
    const std::uint32_t end = group + 1u < table.group_count ? table.groups[group + 1u].first : table.polygon_count;
    for (std::uint32_t number = end; number-- > first;) visit(static_cast<Link>(number), table.groups[group]);
  }
}

/// Deals a sorted list of entries out to the bands in which they begin. Each band's list has the reverse order of the
/// whole. `band_of(entry)` gives the band.
template <class Entry, class BandOf>
[[gnu::always_inline]] inline void deal_to_bands(Entry* entries, Link first, std::span<Link> bands, BandOf band_of) {
  for (Link& band : bands) band = no_link;
  while (first != no_link) {
    Entry& entry = entries[first];
    Link& band = bands[static_cast<std::size_t>(band_of(entry))];
    const Link next = entry.next;
    entry.next = band;
    band = first;
    first = next;
  }
}

}  // namespace spanline
