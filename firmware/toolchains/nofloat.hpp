#pragma once

// Put before every source by arm-m4-nofloat.cmake. The standard headers name float and double in functions that nobody
// here calls; from the last line on, a function that has a float at run time is an error.
#include <arm_acle.h>

#include <algorithm>
#include <array>
#include <bit>
#include <climits>
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <new>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>

#pragma GCC target("general-regs-only")
