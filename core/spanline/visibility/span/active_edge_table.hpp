#pragma once
/// @file
/// The active-edge table of a scan-line algorithm, after W. J. Bouknight, "A Procedure for Generation of
/// Three-dimensional Half-toned Computer Graphics Presentations" (1970), and lecture 002, "Depth Coherence".
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "spanline/raster/link.hpp"
#include "spanline/visibility/span/awake_polygon.hpp"

namespace spanline {

/// The sorting key of an awake polygon: its first column on the row in the upper half, the byte offset of its record in
/// the lower half.
using AwakeKey = std::conditional_t<(sizeof(void*) > 4), std::uint64_t, std::uint32_t>;
namespace awake_key {
inline constexpr int column_shift = sizeof(AwakeKey) * 4;
inline constexpr std::size_t largest_offset = (std::size_t{1} << column_shift) - 1;
/// The sentinel after the last key; its column lies to the right of every picture.
inline constexpr AwakeKey end = AwakeKey{0x7fff} << column_shift | largest_offset;

[[nodiscard]] inline AwakeKey make(std::int32_t column, std::size_t offset) {
  return static_cast<AwakeKey>(word(column)) << column_shift | static_cast<AwakeKey>(offset);
}
[[nodiscard]] inline std::int32_t column(AwakeKey key) { return static_cast<std::int32_t>(key >> column_shift); }
[[nodiscard]] inline std::size_t offset(AwakeKey key) { return static_cast<std::size_t>(key & largest_offset); }
}  // namespace awake_key

/// The active-edge table AET: the awake polygons of a row, sorted by their first column. The order is kept from row to
/// row and repaired where it changes.
///
/// Keys are in two arrays that are exchanged every row. The new polygons of a row are kept sorted at the end of the
/// array that is written next, until `step` merges them in.
class ActiveEdgeTable {
 public:
  /// `keys` has 2·(capacity + 2) entries. Records begin at `records` and are `stride` bytes apart.
  void begin_frame(std::span<AwakeKey> keys, std::byte* records, std::size_t capacity, std::size_t stride);

  /// The keys of the current row, closed by the sentinel.
  [[nodiscard]] const AwakeKey* sorted() const { return current_ + 1; }
  [[nodiscard]] std::byte* records() const { return records_; }
  [[nodiscard]] AwakePolygon& at(AwakeKey key) const {
    return *reinterpret_cast<AwakePolygon*>(records_ + awake_key::offset(key));
  }

  /// Returns a free record, or null if there is none.
  [[nodiscard]] AwakePolygon* take() {
    AwakePolygon* record = free_;
    if (record != nullptr) {
      free_ = record->next;
    } else if (untouched_ != 0) {
      record = reinterpret_cast<AwakePolygon*>(records_ + --untouched_ * stride_);
    } else {
      return nullptr;
    }
    if (++awake_ > peak_) peak_ = awake_;
    return record;
  }
  /// Enters a polygon that was just placed on the next row.
  void enter(AwakePolygon& polygon, std::int32_t column) {
    const AwakeKey key =
        awake_key::make(column, static_cast<std::size_t>(reinterpret_cast<std::byte*>(&polygon) - records_));
    AwakeKey* place = entering_--;
    while (*place < key) {
      place[-1] = place[0];
      ++place;
    }
    place[-1] = key;
  }

  /// Frees the records of polygons that ended above `row`, to make room in a full table.
  void reap(std::int32_t row);
  enum class Evicted : std::uint8_t { farthest, nearest };
  /// Makes room in a full table for a polygon with the bound `nearest` and this number. Compared are the nearer bounds
  /// of all polygons on or entering the row; of equal ones the earlier number counts as nearer. `farthest` removes the
  /// farthest polygon if it is behind the new one, `nearest` the nearest if it is in front of the new one. Output: the
  /// record, free for use; null if no polygon qualifies.
  template <Evicted Chosen>
  [[nodiscard]] AwakePolygon* evict(std::uint32_t nearest, Link number);

  /// Empties a table that is on the row above `row`. Polygons that reach `row` go into its bucket.
  void stand_back(const PolygonSource& source, std::int32_t row);
  [[nodiscard]] bool has_records() const { return capacity_ != 0; }

  /// Steps every polygon to `row`, removes those that end, and merges the new ones in. Output: the number of exchanges
  /// that repaired the order.
  std::uint32_t step(const PolygonSource& source, std::int32_t row);

  /// The most records in use at any time of the frame.
  [[nodiscard]] std::uint32_t peak() const { return peak_; }

 private:
  void release(AwakePolygon& polygon) {
    polygon.next = free_;
    free_ = &polygon;
    --awake_;
  }

  AwakeKey* current_ = nullptr;   ///< keys of the current row, between the sentinels 0 and `end`
  AwakeKey* next_ = nullptr;      ///< the array for the keys of the next row
  AwakeKey* entering_ = nullptr;  ///< the first of the new keys, which are sorted
  std::byte* records_ = nullptr;
  std::size_t stride_ = 0, capacity_ = 0;  ///< bytes from record to record; number of records
  AwakePolygon* free_ = nullptr;           ///< list of records that are free again
  std::uint32_t untouched_ = 0;            ///< records at the start of the pool that were never used
  std::uint32_t awake_ = 0, peak_ = 0;     ///< records in use, now and at most
};

}  // namespace spanline
