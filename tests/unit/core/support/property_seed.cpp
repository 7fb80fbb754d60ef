// Properties try the same cases in every run; RC_PARAMS in the environment chooses others.
#include <cstdlib>

namespace spanline::test {
namespace {

[[maybe_unused]] const bool seeded = setenv("RC_PARAMS", "seed=1 max_success=500", 0) == 0;

}  // namespace
}  // namespace spanline::test
