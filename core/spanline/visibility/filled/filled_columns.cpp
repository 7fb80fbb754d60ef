#include "spanline/visibility/filled/filled_columns.hpp"

namespace spanline {

void FilledColumns::begin_band(std::int32_t width, std::int32_t lines) {
  const std::int32_t words = (width + 31) / 32;
  words_shift_ = words > static_cast<std::int32_t>(most_cells) ? 1 : 0;
  for (std::int32_t i = 0; i < lines; ++i) {
    std::uint32_t* const words_of_line = line(i);
    for (std::int32_t k = 0; k < words; ++k) words_of_line[k] = 0;
    if ((width & 31) != 0) words_of_line[words - 1] = column_bits::from(width);
    words_of_line[words] = ~std::uint32_t{0};
  }
  for (std::uint16_t& cell : open_words_) cell = 0;
  for (std::int32_t k = 0; k < words; ++k)
    open_words_[k >> words_shift_] = static_cast<std::uint16_t>(open_words_[k >> words_shift_] + lines);
  const int cells = (words + words_shift_) >> words_shift_;
  open_cells_ = ~std::uint32_t{0} >> (32 - cells);
}

}  // namespace spanline
