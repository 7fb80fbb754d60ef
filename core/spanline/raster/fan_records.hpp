#pragma once
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "spanline/raster/half_plane.hpp"
#include "spanline/raster/link.hpp"
#include "spanline/raster/outline.hpp"
#include "spanline/raster/outline_header.hpp"
#include "spanline/raster/screen_vertex.hpp"

namespace spanline {

/// A triangle whose corners are not in the mesh's indices: a piece of a clipped polygon, or of the fan of a larger one.
struct FanTriangle {
  Link corner[3];  ///< vertex numbers within the group
  Link triangle;   ///< triangle number within the group, which gives its normal, colour and id
  Link polygon;    ///< polygon number within the mesh, which gives its normal and colour
};

/// The pool `fans` of the polygon table: records of five numbers each. A triangle takes one. An outline takes two for
/// up to five corners and three for up to eight, so never more than its fan: header, origin, end row, triangle and
/// polygon, and then its vertex numbers.
class FanRecords {
 public:
  static constexpr unsigned numbers_in_record = 5;

  FanRecords() = default;
  /// Takes memory of five numbers a record, for fewer records than a Link can number.
  explicit FanRecords(std::span<Link> numbers)
      : numbers_(numbers.data()), capacity_(static_cast<Link>(numbers.size() / numbers_in_record)) {}

  /// Records that an outline of so many corners takes, with so many lines of its own (FanDiagonals).
  [[nodiscard]] static constexpr Link records_of_outline(unsigned corners, unsigned lines = 0) {
    if (lines == 0) return corners <= numbers_in_record ? 2 : 3;
    const unsigned numbers = numbers_in_record + corners + lines * numbers_in_line;
    return static_cast<Link>((numbers + numbers_in_record - 1) / numbers_in_record);
  }

  void clear() { used_ = 0; }
  /// Records in use.
  [[nodiscard]] Link used() const { return used_; }
  [[nodiscard]] bool has_room(unsigned records) const { return capacity_ >= used_ + records; }

  /// Appends a triangle, for which there is room. Output: the number of its record.
  Link append(const FanTriangle& fan) {
    Link* to = at(used_);
    for (const Link corner : fan.corner) *to++ = corner;
    to[0] = fan.triangle;
    to[1] = fan.polygon;
    return take(1);
  }
  /// Appends an outline, for which there is room. `triangle` is the number of its fan's first triangle.
  [[gnu::always_inline]] inline Link append(const Outline& outline, const OutlineLayout& layout, Link triangle,
                                            Link polygon) {
    Link* to = at(used_);
    to[0] = OutlineHeader(outline.count(), layout).bits();
    to[1] = static_cast<Link>(layout.origin);
    to[2] = static_cast<Link>(layout.end_row);
    to[3] = triangle;
    to[4] = static_cast<Link>(polygon | outline_flag);
    to += numbers_in_record;
    for (unsigned i = 0; i < outline.count(); ++i) *to++ = outline.number(i);
    return take(records_of_outline(outline.count()));
  }

  /// The same for an outline that clipping has made, with room for lines that divide it in place of its own diagonals.
  Link append(const Outline& outline, const OutlineLayout& layout, Link triangle, Link polygon, unsigned lines) {
    const Link record = append(outline, layout, triangle, polygon);
    Link* first = at(record);
    first[1] = static_cast<Link>(first[1] | lines << lines_shift);
    used_ = static_cast<Link>(record + records_of_outline(outline.count(), lines));
    return record;
  }
  /// Sets line `i` of such an outline.
  void set_line(Link record, unsigned i, const HalfPlane& line) {
    Link* to = at(record);
    to += numbers_in_record + OutlineHeader(to[0]).corners() + i * numbers_in_line;
    for (const std::int32_t value : {line.a, line.b, line.c}) {
      *to++ = static_cast<Link>(word(value));
      if constexpr (sizeof(Link) == 2) *to++ = static_cast<Link>(word(value) >> 16);
    }
  }

  [[nodiscard]] bool is_outline(Link record) const { return (at(record)[4] & outline_flag) != 0; }
  /// The triangle, or an outline's reference triangle with the number of its fan's first one.
  [[nodiscard]] FanTriangle triangle(Link record) const {
    const Link* from = at(record);
    if ((from[4] & outline_flag) == 0) return {{from[0], from[1], from[2]}, from[3], from[4]};
    const Link* reference = from + numbers_in_record + OutlineHeader(from[0]).reference();
    return {{from[numbers_in_record], reference[0], reference[1]}, from[3], static_cast<Link>(from[4] & ~outline_flag)};
  }
  [[nodiscard]] PlacedOutline outline(const ScreenVertex* vertices, Link record) const {
    const Link* from = at(record);
    const OutlineHeader header(from[0]);
    return {{vertices, from + numbers_in_record, header.corners()},
            header,
            static_cast<std::int32_t>(from[1] & ((1u << lines_shift) - 1)),
            static_cast<std::int32_t>(from[2]),
            static_cast<unsigned>(from[1]) >> lines_shift};
  }

 private:
  static constexpr unsigned numbers_in_line = 3 * sizeof(std::int32_t) / sizeof(Link);
  /// The number of an outline's lines stands above its origin, which is below 2^13.
  static constexpr unsigned lines_shift = 13;
  /// Set in the polygon number of an outline's first record.
  static constexpr Link outline_flag = static_cast<Link>(Link{1} << (std::numeric_limits<Link>::digits - 1));

  [[nodiscard]] Link* at(Link record) const { return numbers_ + std::size_t{record} * numbers_in_record; }
  Link take(Link records) {
    const Link first = used_;
    used_ = static_cast<Link>(first + records);
    return first;
  }

  Link* numbers_ = nullptr;
  Link capacity_ = 0;  ///< records that the memory holds
  Link used_ = 0;
};

}  // namespace spanline
