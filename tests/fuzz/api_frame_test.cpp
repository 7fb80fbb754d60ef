// What the fuzzer of the public API does, without a fuzzer: random frames, and none of the statuses is out of its
// reach.
#include <gtest/gtest.h>

#include <set>
#include <utility>
#include <vector>

#include "api_run.hpp"
#include "support/effort.hpp"
#include "support/random.hpp"

namespace spanline::fuzz {
namespace {

std::vector<std::uint8_t> random_bytes(test::Random& random) {
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(random.between(60, 1500)));
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.between(0, 255));
  return bytes;
}

TEST(ApiFrames, AreDrawnAlikeInBandsOfAnyHeightAndByBothFamilies) {
  test::Random random(1);
  Statuses told;
  for (int i = 0; i < test::rounds(400); ++i)
    ASSERT_EQ(fault_in(decode_frame(random_bytes(random)), told), "") << "round " << i;
}

TEST(ApiFrames, ReachEveryStatus) {
  test::Random random(2);
  Statuses told;
  for (int i = 0; i < test::sample_size(400); ++i) (void)fault_in(decode_frame(random_bytes(random)), told);
  std::set<std::pair<Fault, Pool>> seen;
  for (const Status& status : told)
    seen.insert({status.fault, status.fault == Fault::bad_configuration ? Pool::none : status.pool});
  // Links of 32 bits number more triangles than a call can have: Fault::too_many_triangles is for firmware alone.
  for (const Fault fault :
       {Fault::none, Fault::bad_configuration, Fault::bad_planes, Fault::bad_focal, Fault::too_many_lights,
        Fault::no_frame, Fault::bad_step, Fault::shader_missing, Fault::sink_failed})
    EXPECT_TRUE(seen.contains({fault, Pool::none})) << to_string(fault);
  for (const Pool pool : {Pool::memory, Pool::instances, Pool::vertices, Pool::shades, Pool::textures, Pool::polygons,
                          Pool::fans, Pool::active, Pool::awake, Pool::fragments, Pool::layers})
    EXPECT_TRUE(seen.contains({Fault::pool_full, pool})) << to_string(pool);
}

}  // namespace
}  // namespace spanline::fuzz
