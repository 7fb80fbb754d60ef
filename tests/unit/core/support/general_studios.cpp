#include "support/ready_made_studios.hpp"

namespace spanline::test {

template class Studio<GeneralTraits<>>;
template class Studio<GeneralTraits<Rgb565, Depth24<>>>;
template class Studio<GeneralTraits<Rgb565, Depth24<>, Spanning>>;

}  // namespace spanline::test
