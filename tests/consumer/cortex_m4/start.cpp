// All that the cube needs to run on QEMU's mps2-an386: vectors, a console and an end by semihosting, and the four
// functions of a C library that compilers call by themselves.
#include <cstddef>
#include <cstdint>

#include "console.hpp"

int main();

namespace {

/// A call of Arm's semihosting: QEMU does what the host would.
void semihosting(std::uint32_t operation, std::uintptr_t argument) {
  register std::uint32_t r0 asm("r0") = operation;
  register std::uintptr_t r1 asm("r1") = argument;
  asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
}

[[noreturn]] void end(int code) {
  constexpr std::uintptr_t application_exit = 0x20026;
  std::uintptr_t block[2] = {application_exit, static_cast<std::uintptr_t>(code)};
  for (;;) semihosting(0x20, reinterpret_cast<std::uintptr_t>(block));  // SYS_EXIT_EXTENDED
}

[[noreturn]] void fault() { end(70); }

}  // namespace

void write(const char* text) { semihosting(0x04, reinterpret_cast<std::uintptr_t>(text)); }  // SYS_WRITE0

extern "C" {

[[noreturn]] void start() { end(main()); }

using Handler = void (*)();
// The stack's first address, reset, and what a Cortex-M4 calls where it cannot go on.
[[gnu::section(".vectors"), gnu::used]] const Handler vectors[] = {
    reinterpret_cast<Handler>(std::uintptr_t{0x20400000}), start, fault, fault, fault, fault, fault};

// gcc makes calls of these functions of loops such as theirs, which volatile prevents.
void* memcpy(void* to, const void* from, std::size_t size) {
  auto* target = static_cast<volatile char*>(to);
  for (std::size_t i = 0; i < size; ++i) target[i] = static_cast<const char*>(from)[i];
  return to;
}
void* memmove(void* to, const void* from, std::size_t size) {
  if (to <= from) return memcpy(to, from, size);
  auto* target = static_cast<volatile char*>(to);
  for (std::size_t i = size; i > 0; --i) target[i - 1] = static_cast<const char*>(from)[i - 1];
  return to;
}
void* memset(void* to, int value, std::size_t size) {
  auto* target = static_cast<volatile char*>(to);
  for (std::size_t i = 0; i < size; ++i) target[i] = static_cast<char>(value);
  return to;
}
int memcmp(const void* left, const void* right, std::size_t size) {
  const auto *a = static_cast<const volatile unsigned char*>(left),
             *b = static_cast<const volatile unsigned char*>(right);
  for (std::size_t i = 0; i < size; ++i) {
    if (a[i] != b[i]) return a[i] < b[i] ? -1 : 1;
  }
  return 0;
}

}  // extern "C"
