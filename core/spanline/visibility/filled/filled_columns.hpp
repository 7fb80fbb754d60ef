#pragma once
/// @file
/// Which pixels of a band are filled, for drawing from front to back: after S. Chen and D. Gordon, "Front-to-Back
/// Display of BSP Trees" (1991), which lecture 000 recommends. They keep lists of segments, this keeps bits.
#include <cstddef>
#include <cstdint>
#include <span>

#include "spanline/memory/arena.hpp"
#include "spanline/raster/row_columns.hpp"
#include "spanline/visibility/filled/column_bits.hpp"

namespace spanline {

/// A record of the filled columns of a band's lines, a bit for each pixel. Whoever draws from front to back fills only
/// what is not filled yet, so every pixel is written once.
///
/// The band is divided into cells, of 32 columns and all lines in pictures up to 1,024 columns wide and of 64 columns
/// in wider ones. A cell that is filled completely is closed: polygons whose columns lie in closed cells are hidden.
class FilledColumns {
 public:
  /// Words of a line. A line ends with a word that is always filled, so that a window of 32 columns may begin at any
  /// column.
  [[nodiscard]] static constexpr std::size_t words_a_line(std::size_t width) { return (width + 31) / 32 + 1; }

  constexpr void take(Arena& arena, std::size_t width, std::size_t lines) {
    words_ = arena.take<std::uint32_t>(words_a_line(width) * lines);
    stride_ = words_a_line(width);
  }

  /// Empties the record for a band of so many lines. Columns beyond the picture's width count as filled.
  void begin_band(std::int32_t width, std::int32_t lines);

  /// Whether every pixel is filled.
  [[nodiscard]] bool full() const { return open_cells_ == 0; }
  /// Whether the cells of the columns [first, end), which are not empty, are closed.
  [[nodiscard]] bool is_closed(std::int32_t first, std::int32_t end) const {
    const int low = first >> (5 + words_shift_), high = (end - 1) >> (5 + words_shift_);
    return (((std::uint32_t{2} << high) - (std::uint32_t{1} << low)) & open_cells_) == 0;
  }

  /// The words of a line.
  [[nodiscard]] std::uint32_t* line(std::int32_t line) {
    return words_.data() + static_cast<std::size_t>(line) * stride_;
  }
  [[nodiscard]] std::size_t stride() const { return stride_; }
  [[nodiscard]] std::size_t bytes() const { return words_.size_bytes(); }

  /// Marks columns of word `index` of a line as filled.
  [[gnu::always_inline]] void mark(std::uint32_t* line, std::int32_t index, std::uint32_t columns) {
    const std::uint32_t before = line[index], now = before | columns;
    line[index] = now;
    if (now == ~std::uint32_t{0} && now != before) note_full_word(index);
  }
  /// Notes that word `index` of a line, whose last columns were just filled, is full.
  [[gnu::noinline]] void note_full_word(std::int32_t index) { close_word(index); }

  /// Fills a run of a line: calls use(columns) for each part of it that was not filled.
  template <class Use>
  [[gnu::always_inline]] void fill(std::uint32_t* line, RowColumns run, Use use) {
    using namespace column_bits;
    const std::int32_t first = word_of(run.first), last = word_of(run.end - 1);
    const std::uint32_t head = from(run.first), tail = up_to(run.end - 1);
    if (first == last) {
      const std::uint32_t range = head & tail, before = line[first];
      if ((before & range) == 0) {
        mark(line, first, range);
        use(run);
        return;
      }
      if ((range & ~before) == 0) return;
    } else {
      std::uint32_t any = (line[first] & head) | (line[last] & tail),
                    all = (line[first] | ~head) & (line[last] | ~tail);
      for (std::int32_t i = first + 1; i < last; ++i) {
        any |= line[i];
        all &= line[i];
      }
      if (~all == 0) return;
      if (any == 0) {
        mark(line, first, head);
        mark(line, last, tail);
        for (std::int32_t i = first + 1; i < last; ++i) {
          line[i] = ~std::uint32_t{0};
          close_word(i);
        }
        use(run);
        return;
      }
    }
    fill_gaps(line, run, use);
  }

  // A window of 32 columns may begin with any column: with column `shift`, [0, 31], of word `index` of a line, to which
  // `words` points. The first column is the most significant bit.

  /// The columns of a window that are filled.
  [[nodiscard]] static std::uint32_t window(const std::uint32_t* words, int shift) {
    return words[0] << shift | (words[1] >> 1) >> (31 - shift);
  }
  /// Fills columns of a window. Output: those that were not filled.
  [[gnu::always_inline]] std::uint32_t fill_window(std::uint32_t* words, std::int32_t index, int shift,
                                                   std::uint32_t columns) {
    const std::uint32_t first = words[0], second = words[1];
    const std::uint32_t now = columns & ~(first << shift | (second >> 1) >> (31 - shift));
    if (now == 0) return 0;
    const std::uint32_t first_now = first | now >> shift, second_now = second | (now << 1) << (31 - shift);
    words[0] = first_now;
    words[1] = second_now;
    if (first_now == ~std::uint32_t{0} && first != first_now) note_full_word(index);
    if (second_now == ~std::uint32_t{0} && second != second_now) note_full_word(index + 1);
    return now;
  }
  /// The same for a window that is one word of a line.
  [[gnu::always_inline]] std::uint32_t fill_whole_word(std::uint32_t* words, std::int32_t index,
                                                       std::uint32_t columns) {
    const std::uint32_t before = *words, now = columns & ~before;
    if (now == 0) return 0;
    *words = before | now;
    if ((before | now) == ~std::uint32_t{0}) note_full_word(index);
    return now;
  }
  /// Whether the columns [first, end), at most 32, are filled on the lines [first_line, end_line).
  [[nodiscard]] bool is_filled(std::int32_t first, std::int32_t end, std::int32_t first_line,
                               std::int32_t end_line) const {
    const std::uint32_t* words =
        words_.data() + static_cast<std::size_t>(first_line) * stride_ + column_bits::word_of(first);
    const std::uint32_t columns = column_bits::between(0, end - first);
    const int shift = first & 31;
    for (; first_line < end_line; ++first_line, words += stride_)
      if ((columns & ~window(words, shift)) != 0) return false;
    return true;
  }

  /// Fills the columns of word `index` that are set in `columns` and not filled, of which `use` gets the runs. `open`
  /// and the result are as for column_bits::for_each_run.
  template <class Use>
  [[gnu::always_inline]] std::int32_t fill_word(std::uint32_t* line, std::int32_t index, std::uint32_t columns,
                                                std::int32_t open, Use use) {
    const std::int32_t column = index * column_bits::columns_a_word;
    const std::uint32_t now = columns & ~line[index];
    if (now == 0) {
      if (open >= 0) use(RowColumns{open, column});
      return -1;
    }
    mark(line, index, now);
    return column_bits::for_each_run(now, column, open, [&](std::int32_t first, std::int32_t end) {
      use(RowColumns{first, end});
    });
  }

  /// Calls use(columns) for each run of a line that is not filled, and leaves the record as it is.
  template <class Use>
  void for_each_gap(const std::uint32_t* line, Use use) const {
    const auto words = static_cast<std::int32_t>(stride_) - 1;
    std::int32_t open = -1;
    for (std::int32_t i = 0; i <= words; ++i) {
      const std::int32_t column = i * column_bits::columns_a_word;
      if (line[i] != ~std::uint32_t{0})
        open = column_bits::for_each_run(~line[i], column, open, [&](std::int32_t first, std::int32_t end) {
          use(RowColumns{first, end});
        });
      else if (open >= 0) {
        use(RowColumns{open, column});
        open = -1;
      }
    }
  }

 private:
  [[gnu::always_inline]] void close_word(std::int32_t index) {
    const std::int32_t cell = index >> words_shift_;
    const auto open = static_cast<std::uint16_t>(open_words_[cell] - 1);
    open_words_[cell] = open;
    if (open == 0) open_cells_ &= ~(std::uint32_t{1} << cell);
  }
  /// As `fill`, for a run of which some columns are filled.
  template <class Use>
  [[gnu::noinline]] void fill_gaps(std::uint32_t* line, RowColumns run, Use use) {
    const std::int32_t last = column_bits::word_of(run.end - 1);
    std::uint32_t range = column_bits::from(run.first);
    std::int32_t open = -1;
    for (std::int32_t i = column_bits::word_of(run.first); i <= last; ++i) {
      if (i == last) range &= column_bits::up_to(run.end - 1);
      open = fill_word(line, i, range, open, use);
      range = ~std::uint32_t{0};
    }
    if (open >= 0) use(RowColumns{open, (last + 1) * column_bits::columns_a_word});
  }

  static constexpr std::size_t most_cells = 32;

  std::span<std::uint32_t> words_{};
  std::size_t stride_ = 0;                ///< words of a line
  std::uint16_t open_words_[most_cells];  ///< words of each cell that are not full
  std::uint32_t open_cells_ = 0;          ///< bit i: cell i is not closed
  int words_shift_ = 0;                   ///< log2 of a cell's words on a line
};

}  // namespace spanline
