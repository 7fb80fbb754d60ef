#include "spanline/visibility/sort/open_pixels.hpp"

namespace spanline {

bool OpenPixels::trim(std::int32_t line) {
  Columns& own = columns_[static_cast<std::size_t>(line)];
  if (own.end == 0) return false;
  const std::uint32_t* const words = words_of(line);
  std::int32_t first = column_bits::word_of(own.first), last = column_bits::word_of(own.end - 1);
  if (words[first] != 0 && words[last] != 0) return true;
  while (first <= last && words[first] == 0) ++first;
  if (first > last) {
    own = {0, 0};
    return false;
  }
  while (words[last] == 0) --last;
  const std::int32_t left = first * column_bits::columns_a_word, right = (last + 1) * column_bits::columns_a_word;
  if (left > own.first) own.first = static_cast<std::uint16_t>(left);
  if (right < own.end) own.end = static_cast<std::uint16_t>(right);
  return true;
}

bool OpenPixels::tighten(std::int32_t top, BoxScale scale, PackedBox& box) {
  while (first_line_ < end_line_ && !trim(first_line_)) ++first_line_;
  while (first_line_ < end_line_ && !trim(end_line_ - 1)) --end_line_;
  if (first_line_ == end_line_) return false;
  const Columns of_first = columns_[static_cast<std::size_t>(first_line_)];
  std::int32_t first = of_first.first, end = of_first.end;
  for (std::int32_t line = first_line_ + 1; line < end_line_; ++line) {
    // Lines that lie between the others' columns anyway need no trimming.
    const Columns& own = columns_[static_cast<std::size_t>(line)];
    if ((own.first >= first && own.end <= end) || !trim(line)) continue;
    if (own.first < first) first = own.first;
    if (own.end > end) end = own.end;
  }
  box = PackedBox(first, end, top + first_line_, top + end_line_, scale);
  return true;
}

}  // namespace spanline
