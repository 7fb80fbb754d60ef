// The four functions that gcc may call without being asked. This file is compiled with
// -fno-tree-loop-distribute-patterns, or their loops would be turned into calls of themselves.
#include <cstddef>
#include <cstdint>

namespace {

using Word [[gnu::may_alias]] = std::uint32_t;
using Byte = unsigned char;

constexpr std::size_t word_size = sizeof(Word);

/// Words a turn of the inner loop: enough to hide the loop's own cost, few enough for the registers of Thumb-1.
constexpr std::size_t unroll = 4;

bool is_aligned(const void* address) { return reinterpret_cast<std::uintptr_t>(address) % word_size == 0; }

bool same_alignment(const void* a, const void* b) {
  return (reinterpret_cast<std::uintptr_t>(a) ^ reinterpret_cast<std::uintptr_t>(b)) % word_size == 0;
}

/// Each turn reads its words before it writes them and never writes ahead of what it has read, so blocks that overlap
/// are copied rightly too as long as `to` lies below `from`.
void copy_ascending(void* to, const void* from, std::size_t size) {
  auto* out = static_cast<Byte*>(to);
  const auto* in = static_cast<const Byte*>(from);
  if (same_alignment(out, in)) {
    for (; size != 0 && !is_aligned(out); --size) *out++ = *in++;
    auto* out_words = reinterpret_cast<Word*>(out);
    const auto* in_words = reinterpret_cast<const Word*>(in);
    for (; size >= unroll * word_size; size -= unroll * word_size, out_words += unroll, in_words += unroll) {
      const Word a = in_words[0], b = in_words[1], c = in_words[2], d = in_words[3];
      out_words[0] = a, out_words[1] = b, out_words[2] = c, out_words[3] = d;
    }
    for (; size >= word_size; size -= word_size) *out_words++ = *in_words++;
    out = reinterpret_cast<Byte*>(out_words);
    in = reinterpret_cast<const Byte*>(in_words);
  }
  for (; size != 0; --size) *out++ = *in++;
}

}  // namespace

extern "C" {

void* memcpy(void* to, const void* from, std::size_t size) {
  copy_ascending(to, from, size);
  return to;
}

void* memmove(void* to, const void* from, std::size_t size) {
  auto* out = static_cast<Byte*>(to);
  const auto* in = static_cast<const Byte*>(from);
  if (out < in || out >= in + size) {
    copy_ascending(to, from, size);
    return to;
  }
  out += size;
  in += size;
  if (same_alignment(out, in)) {
    for (; size != 0 && !is_aligned(out); --size) *--out = *--in;
    for (; size >= word_size; size -= word_size) {
      out -= word_size;
      in -= word_size;
      *reinterpret_cast<Word*>(out) = *reinterpret_cast<const Word*>(in);
    }
  }
  for (; size != 0; --size) *--out = *--in;
  return to;
}

void* memset(void* to, int value, std::size_t size) {
  auto* out = static_cast<Byte*>(to);
  const auto byte = static_cast<Byte>(value);
  const Word word = 0x01010101U * byte;
  for (; size != 0 && !is_aligned(out); --size) *out++ = byte;
  auto* words = reinterpret_cast<Word*>(out);
  for (; size >= unroll * word_size; size -= unroll * word_size, words += unroll) {
    words[0] = word, words[1] = word, words[2] = word, words[3] = word;
  }
  for (; size >= word_size; size -= word_size) *words++ = word;
  out = reinterpret_cast<Byte*>(words);
  for (; size != 0; --size) *out++ = byte;
  return to;
}

int memcmp(const void* a, const void* b, std::size_t size) {
  const auto* left = static_cast<const Byte*>(a);
  const auto* right = static_cast<const Byte*>(b);
  if (is_aligned(left) && is_aligned(right)) {
    for (; size >= word_size && *reinterpret_cast<const Word*>(left) == *reinterpret_cast<const Word*>(right);
         size -= word_size) {
      left += word_size;
      right += word_size;
    }
  }
  for (; size != 0; --size, ++left, ++right) {
    if (*left != *right) return *left - *right;
  }
  return 0;
}

}  // extern "C"
