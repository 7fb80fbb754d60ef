#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "spanline/raster/link.hpp"
#include "spanline/visibility/span/awake_polygon.hpp"

namespace spanline {

/// An awake polygon in the order of the row: its first column on top, the place of its record below.
using AwakeKey = std::conditional_t<(sizeof(void*) > 4), std::uint64_t, std::uint32_t>;
namespace awake_key {
inline constexpr int column_shift = sizeof(AwakeKey) * 4;
inline constexpr std::size_t largest_offset = (std::size_t{1} << column_shift) - 1;
/// Behind the last; its column lies right of every picture.
inline constexpr AwakeKey end = AwakeKey{0x7fff} << column_shift | largest_offset;

[[nodiscard]] inline AwakeKey make(std::int32_t column, std::size_t offset) {
  return static_cast<AwakeKey>(word(column)) << column_shift | static_cast<AwakeKey>(offset);
}
[[nodiscard]] inline std::int32_t column(AwakeKey key) { return static_cast<std::int32_t>(key >> column_shift); }
[[nodiscard]] inline std::size_t offset(AwakeKey key) { return static_cast<std::size_t>(key & largest_offset); }
}  // namespace awake_key

/// The active-edge table AET: the awake polygons of a row, sorted by their first column. Order is kept from row to row
/// and repaired where it changes (lecture 002, "Depth Coherence").
///
/// Keys stand in two arrays that change places every row. New polygons of a row wait, sorted, at the end of the array
/// that is written next, until they are merged in.
class ActiveEdgeTable {
 public:
  /// `keys` has 2·(capacity + 2) entries; records lie `stride` bytes apart from `records` on.
  void begin_frame(std::span<AwakeKey> keys, std::byte* records, std::size_t capacity, std::size_t stride);

  [[nodiscard]] const AwakeKey* sorted() const { return current_ + 1; }
  [[nodiscard]] std::byte* records() const { return records_; }
  [[nodiscard]] AwakePolygon& at(AwakeKey key) const {
    return *reinterpret_cast<AwakePolygon*>(records_ + awake_key::offset(key));
  }

  /// A free record, or null.
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
  /// Enters a polygon that was just placed on the row to come.
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

  /// For a full table: frees the records of polygons that ended above `row`.
  void reap(std::int32_t row);
  enum class Evicted : std::uint8_t { farthest, nearest };
  /// For a full table: takes out the farthest polygon, on or entering the row, of equal ones the latest, if it comes
  /// behind a polygon with these bounds and number; or the nearest, of equal ones the earliest, if it comes before that
  /// one. Its record is free for use; null if there is none.
  template <Evicted Chosen>
  [[nodiscard]] AwakePolygon* evict(std::uint32_t nearest, Link number);

  /// Empties a table that stands on the row above `row`: polygons that go on wait in the bucket of `row`.
  void stand_back(const PolygonSource& source, std::int32_t row);
  [[nodiscard]] bool has_records() const { return capacity_ != 0; }

  /// Steps every polygon to `row`, drops those that end, and merges the new ones in. Output: how many keys had to move
  /// to repair the order.
  std::uint32_t step(const PolygonSource& source, std::int32_t row);

  [[nodiscard]] std::uint32_t peak() const { return peak_; }

 private:
  void release(AwakePolygon& polygon) {
    polygon.next = free_;
    free_ = &polygon;
    --awake_;
  }

  AwakeKey* current_ = nullptr;  ///< 0, keys, end
  AwakeKey* next_ = nullptr;
  AwakeKey* entering_ = nullptr;  ///< the first new key
  std::byte* records_ = nullptr;
  std::size_t stride_ = 0, capacity_ = 0;
  AwakePolygon* free_ = nullptr;
  std::uint32_t untouched_ = 0;  ///< records that were never used
  std::uint32_t awake_ = 0, peak_ = 0;
};

}  // namespace spanline
