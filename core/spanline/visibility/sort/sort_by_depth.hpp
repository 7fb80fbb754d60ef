#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "spanline/raster/link.hpp"

namespace spanline {

/// A radix sort of linked entries, the least significant byte first (H. Hollerith's card sorter; D. Knuth, "The Art of
/// Computer Programming", vol. 3, 5.2.5). It takes no second array: an entry is moved from queue to queue by its link,
/// and equal entries keep their order.
///
/// `queues` has room for `radix_queues` links. `byte_of(entry, pass)` gives an entry's digit, [0, 255]. Entries are
/// linked by their member `next`, from `first` to no_link. Output: the first of the sorted entries.
inline constexpr std::size_t radix_queues = 512;

template <class Entry, class ByteOf>
[[gnu::noinline]] Link sort_by_bytes(Entry* entries, Link first, unsigned passes, std::span<Link> queues,
                                     ByteOf byte_of) {
  constexpr unsigned digits = 256;
  Link* const heads = queues.data();
  Link* const tails = heads + digits;
  for (unsigned pass = 0; pass < passes; ++pass) {
    for (unsigned i = 0; i < digits; ++i) heads[i] = no_link;
    while (first != no_link) {
      Entry& entry = entries[first];
      const std::uint32_t digit = byte_of(entry, pass);
      if (heads[digit] == no_link)
        heads[digit] = first;
      else
        entries[tails[digit]].next = first;
      tails[digit] = first;
      first = entry.next;
    }
    Link last = no_link;
    for (unsigned i = 0; i < digits; ++i) {
      if (heads[i] == no_link) continue;
      if (last == no_link)
        first = heads[i];
      else
        entries[last].next = heads[i];
      last = tails[i];
    }
    if (last != no_link) entries[last].next = no_link;
  }
  return first;
}

}  // namespace spanline
