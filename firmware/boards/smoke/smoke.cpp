// Prints, and proves what start-up and the common functions promise: the exit code says which promise was broken.
#include <board.hpp>
#include <cstddef>

extern "C" {
void* memcpy(void*, const void*, std::size_t);
void* memmove(void*, const void*, std::size_t);
void* memset(void*, int, std::size_t);
int memcmp(const void*, const void*, std::size_t);
}

namespace {

std::uint32_t initialised = 0x12345678;
std::uint32_t zeroed;
volatile std::uint32_t seven = 7;
std::uint32_t constructed = seven;

constexpr std::size_t block = 64;
constexpr std::size_t longest = 40;
unsigned char source[block];
unsigned char target[block];

void fill_both() {
  for (std::size_t i = 0; i < block; ++i) {
    source[i] = static_cast<unsigned char>(i);
    target[i] = static_cast<unsigned char>(200 + i);
  }
}

bool copies(std::size_t to, std::size_t from, std::size_t size) {
  fill_both();
  memcpy(target + to, source + from, size);
  for (std::size_t i = 0; i < block; ++i) {
    const bool inside = i >= to && i < to + size;
    if (target[i] != static_cast<unsigned char>(inside ? i - to + from : 200 + i)) return false;
  }
  return memcmp(target + to, source + from, size) == 0;
}

bool moves(std::size_t to, std::size_t from, std::size_t size) {
  fill_both();
  memmove(source + to, source + from, size);
  for (std::size_t i = 0; i < block; ++i) {
    const bool inside = i >= to && i < to + size;
    if (source[i] != static_cast<unsigned char>(inside ? i - to + from : i)) return false;
  }
  return true;
}

bool sets(std::size_t to, std::size_t size) {
  fill_both();
  memset(target + to, 0x1a5, size);
  for (std::size_t i = 0; i < block; ++i) {
    const bool inside = i >= to && i < to + size;
    if (target[i] != static_cast<unsigned char>(inside ? 0xa5 : 200 + i)) return false;
  }
  return true;
}

bool compares(std::size_t at, std::size_t size) {
  fill_both();
  memcpy(target + at, source + at, size);
  for (std::size_t i = at; i < at + size; ++i) {
    target[i] = static_cast<unsigned char>(source[i] + 1);
    if (memcmp(target + at, source + at, size) <= 0 || memcmp(source + at, target + at, size) >= 0) return false;
    target[i] = source[i];
  }
  return memcmp(target + at, source + at, size) == 0;
}

bool memory_functions_work() {
  for (std::size_t to = 0; to < 5; ++to) {
    for (std::size_t from = 0; from < 5; ++from) {
      for (std::size_t size = 0; size <= longest; ++size) {
        if (!copies(to, from, size) || !moves(to, from, size) || !moves(4 * to, from, size)) return false;
        if (!sets(to, size) || !compares(to, size)) return false;
      }
    }
  }
  return true;
}

}  // namespace

int main() {
  using namespace spanline::board;
  if (initialised != 0x12345678) return 2;
  if (zeroed != 0) return 3;
  if (constructed != 7) return 4;
  if (!memory_functions_work()) return 5;
  if (stack_used() == 0 || stack_used() >= stack_size()) return 6;
  write("smoke: stack ");
  write_unsigned(stack_used());
  write(" of ");
  write_unsigned(stack_size());
  write(" bytes, number 0x");
  write_hex(0x0badf00d);
  write("\n");
  return 0;
}
