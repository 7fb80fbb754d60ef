// Reciprocals as the host compiles them.
#define SPANLINE_RECIPROCAL_SUITE Reciprocal
#include "math/reciprocal_checks.hpp"
