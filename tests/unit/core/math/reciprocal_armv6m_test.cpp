// Reciprocals by the code of cores without CLZ, long multiply and divide. A program of its own: the functions are
// inline, and one program must not hold both bodies.
#define __ARM_ARCH_6M__ 1
#define SPANLINE_RECIPROCAL_SUITE ReciprocalArmv6m
#include "math/reciprocal_checks.hpp"
