// What clang calls in the place of memcpy and its kind, by the run-time ABI for the Arm architecture (IHI 0043,
// "Memory copying, clearing, and setting"): the digit behind a name says how pointers are aligned, and memset takes the
// size before the value. Images by gcc link none of it.
#include <cstddef>

extern "C" {

void* memcpy(void* to, const void* from, std::size_t size);
void* memmove(void* to, const void* from, std::size_t size);
void* memset(void* to, int value, std::size_t size);

void __aeabi_memcpy(void* to, const void* from, std::size_t size) { memcpy(to, from, size); }
void __aeabi_memcpy4(void* to, const void* from, std::size_t size) { memcpy(to, from, size); }
void __aeabi_memcpy8(void* to, const void* from, std::size_t size) { memcpy(to, from, size); }
void __aeabi_memmove(void* to, const void* from, std::size_t size) { memmove(to, from, size); }
void __aeabi_memmove4(void* to, const void* from, std::size_t size) { memmove(to, from, size); }
void __aeabi_memmove8(void* to, const void* from, std::size_t size) { memmove(to, from, size); }
void __aeabi_memset(void* to, std::size_t size, int value) { memset(to, value, size); }
void __aeabi_memset4(void* to, std::size_t size, int value) { memset(to, value, size); }
void __aeabi_memset8(void* to, std::size_t size, int value) { memset(to, value, size); }
void __aeabi_memclr(void* to, std::size_t size) { memset(to, 0, size); }
void __aeabi_memclr4(void* to, std::size_t size) { memset(to, 0, size); }
void __aeabi_memclr8(void* to, std::size_t size) { memset(to, 0, size); }

}  // extern "C"
