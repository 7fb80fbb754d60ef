#include "support/ready_made_studios.hpp"

namespace spanline::test {

template class Studio<GeneralSeeThroughTraits<>>;
template class Studio<GeneralSeeThroughTraits<Rgb565, Depth24<>>>;
template class Studio<GeneralSeeThroughTraits<Rgb565, Depth24<>, Spanning>>;

}  // namespace spanline::test
