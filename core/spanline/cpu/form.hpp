#pragma once
#include <cstdint>

namespace spanline {

/// Which form of a kernel to take: the fastest that the core has for which the code is built, or the portable one,
/// which every core has. Both give the same bits. The renderer takes the fastest everywhere; the firmware
/// `kernel_twins` asks for both and compares them.
enum class Form : std::uint8_t { fastest, portable };

}  // namespace spanline
