#pragma once
#include <cstdint>

namespace spanline {

/// Which form of a kernel to use: the fastest for the core that the code is built for, or the portable one, which runs
/// on every core. Both give the same bits. The renderer always uses the fastest; the firmware `kernel_twins` runs both
/// and compares them.
enum class Form : std::uint8_t { fastest, portable };

}  // namespace spanline
