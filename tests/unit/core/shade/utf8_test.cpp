// Every character of UTF-8, and what is none.
#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "spanline/finish/utf8_reader.hpp"

namespace spanline::test {
namespace {

std::string encoded(std::uint32_t c) {
  const auto byte = [](std::uint32_t value) { return static_cast<char>(static_cast<unsigned char>(value)); };
  const auto more = [&](int shift) { return byte(0x80 | (c >> shift & 0x3f)); };
  if (c < 0x80) return {byte(c)};
  if (c < 0x800) return {byte(0xc0 | c >> 6), more(0)};
  if (c < 0x10000) return {byte(0xe0 | c >> 12), more(6), more(0)};
  return {byte(0xf0 | c >> 18), more(12), more(6), more(0)};
}

TEST(Utf8Reader, ReadsEveryCharacter) {
  for (std::uint32_t c = 0; c <= 0x10ffff; ++c) {
    const std::string text = encoded(c) + "x";
    Utf8Reader reader(text);
    ASSERT_EQ(reader.next(), c);
    ASSERT_EQ(reader.next(), std::uint32_t{'x'}) << c;
    ASSERT_TRUE(reader.at_end());
  }
}

TEST(Utf8Reader, CountsAQuestionMarkForEachByteThatIsNone) {
  using namespace std::literals;
  for (const std::string_view bad :
       {"\x80"sv, "\xbf"sv, "\xc0"sv, "\xc1"sv, "\xf5"sv, "\xff"sv, "\xc3"sv, "\xe2\x82"sv, "\xf0\x9f\x98"sv}) {
    Utf8Reader reader(bad);
    std::size_t marks = 0;
    for (; !reader.at_end(); ++marks) ASSERT_EQ(reader.next(), std::uint32_t{'?'});
    EXPECT_EQ(marks, bad.size());
  }
  for (const std::string_view bad : {"\xc3(x"sv, "\xc3\xffx"sv, "\xe2\x82(x"sv, "\xe2(\x82x"sv}) {
    Utf8Reader reader(bad);
    EXPECT_EQ(reader.next(), std::uint32_t{'?'}) << "what follows is no part of a character";
  }
}

}  // namespace
}  // namespace spanline::test
