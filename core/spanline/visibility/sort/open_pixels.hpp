#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "spanline/memory/arena.hpp"
#include "spanline/raster/row_columns.hpp"
#include "spanline/visibility/filled/filled_columns.hpp"
#include "spanline/visibility/sort/packed_box.hpp"

namespace spanline {

/// The pixels of one polygon in a band that it may still fill: first all of its pixels that are not filled, from which
/// those are taken where other polygons are in front. A bit for each pixel of the band. Lines count from the band's
/// first.
class OpenPixels {
  struct Columns {
    std::uint16_t first, end;
  };

 public:
  constexpr void take(Arena& arena, std::size_t width, std::size_t lines) {
    stride_ = FilledColumns::words_a_line(width);
    words_ = arena.take<std::uint32_t>(stride_ * lines);
    columns_ = arena.take<Columns>(lines);
  }

  [[nodiscard]] std::size_t bytes() const { return words_.size_bytes() + columns_.size_bytes(); }

  /// A line, to be stepped down.
  struct Line {
    std::uint32_t* words;
    Columns* columns;
    std::size_t stride;

    void step() {
      words += stride;
      ++columns;
    }
  };
  /// Starts with a polygon on the lines [first_line, end_line), which are empty at first. Output: the first of them.
  Line begin(std::int32_t first_line, std::int32_t end_line) {
    first_line_ = first_line;
    end_line_ = end_line;
    for (; first_line < end_line; ++first_line) columns_[static_cast<std::size_t>(first_line)] = {0, 0};
    return {words_of(first_line_), columns_.data() + first_line_, stride_};
  }
  /// Opens the columns of a run that are not in `filled`, the words of the same line.
  [[gnu::always_inline]] static void open(Line line, RowColumns run, const std::uint32_t* filled) {
    *line.columns = {static_cast<std::uint16_t>(run.first), static_cast<std::uint16_t>(run.end)};
    std::uint32_t range = column_bits::from(run.first);
    const std::int32_t last = column_bits::word_of(run.end - 1);
    for (std::int32_t i = column_bits::word_of(run.first); i < last; ++i) {
      line.words[i] = range & ~filled[i];
      range = ~std::uint32_t{0};
    }
    line.words[last] = range & ~filled[last] & column_bits::up_to(run.end - 1);
  }

  /// The lines that may have open pixels.
  [[nodiscard]] std::int32_t first_line() const { return first_line_; }
  [[nodiscard]] std::int32_t end_line() const { return end_line_; }
  /// The part of a run that lies between a line's outermost pixels, [first_line(), end_line()).
  [[nodiscard]] RowColumns common(std::int32_t line, RowColumns run) const {
    const Columns own = columns_[static_cast<std::size_t>(line)];
    return {run.first > own.first ? run.first : own.first, run.end < own.end ? run.end : own.end};
  }
  /// Whether any of the columns, a part of the line's own, is open.
  [[nodiscard]] bool any(std::int32_t line, RowColumns run) const {
    const std::uint32_t* const words = words_of(line);
    const std::int32_t last = column_bits::word_of(run.end - 1);
    std::uint32_t range = column_bits::from(run.first), found = 0;
    for (std::int32_t i = column_bits::word_of(run.first); i < last; ++i) {
      found |= words[i] & range;
      range = ~std::uint32_t{0};
    }
    return (found | (words[last] & range & column_bits::up_to(run.end - 1))) != 0;
  }
  /// Takes columns away, a part of the line's own. Output: the bits that were open, not zero if there were any.
  [[gnu::always_inline]] std::uint32_t close(std::int32_t line, RowColumns run) {
    std::uint32_t* const words = words_of(line);
    const std::int32_t last = column_bits::word_of(run.end - 1);
    std::uint32_t range = column_bits::from(run.first), found = 0;
    const auto close_word = [&](std::uint32_t& columns) {
      found |= columns & range;
      columns &= ~range;
      range = ~std::uint32_t{0};
    };
    for (std::int32_t i = column_bits::word_of(run.first); i < last; ++i) close_word(words[i]);
    range &= column_bits::up_to(run.end - 1);
    close_word(words[last]);
    return found;
  }

  /// Leaves out lines without open pixels at both ends. False if there are no open pixels. `box` becomes a box around
  /// them, to whole words of columns; `top` is the band's first row.
  [[nodiscard]] bool tighten(std::int32_t top, BoxScale scale, PackedBox& box);

  /// Fills what is open, by the record of what is filled: calls use(line, columns), and step() before each line.
  template <class Step, class Use>
  [[gnu::always_inline]] void fill_into(FilledColumns& filled, Step step, Use use) const {
    const std::uint32_t* words = words_of(first_line_);
    std::uint32_t* to = filled.line(first_line_);
    for (std::int32_t at = first_line_; at < end_line_; ++at, words += stride_, to += stride_) {
      step();
      const Columns own = columns_[static_cast<std::size_t>(at)];
      if (own.end == 0) continue;
      const auto fill = [&](RowColumns columns) __attribute__((always_inline)) { use(at, columns); };
      const std::int32_t last = column_bits::word_of(own.end - 1);
      std::int32_t open = -1;
      for (std::int32_t i = column_bits::word_of(own.first); i <= last; ++i)
        open = filled.fill_word(to, i, words[i], open, fill);
      if (open >= 0) fill({open, (last + 1) * column_bits::columns_a_word});
    }
  }

 private:
  /// Moves a line's outermost columns to the words of its outermost open pixels. False if it has none.
  bool trim(std::int32_t line);
  [[nodiscard]] std::uint32_t* words_of(std::int32_t line) const {
    return words_.data() + static_cast<std::size_t>(line) * stride_;
  }

  std::span<std::uint32_t> words_{};
  std::span<Columns> columns_{};  ///< outermost pixels of each line; an `end` of 0 for lines without pixels
  std::size_t stride_ = 0;
  std::int32_t first_line_ = 0, end_line_ = 0;
};

}  // namespace spanline
