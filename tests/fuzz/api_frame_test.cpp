// What the fuzzer of the public API does, without a fuzzer and for the same inputs every time: frames that random bytes
// mean are drawn as they should be, and no status that a program can provoke is out of their reach.
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "api_run.hpp"
#include "support/random.hpp"

namespace spanline::fuzz {
namespace {

// So many that they take about a minute under sanitizers.
constexpr int frames = 12000;

std::vector<std::uint8_t> random_bytes(test::Random& random) {
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(random.between(60, 1500)));
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.between(0, 255));
  return bytes;
}

/// A status without its number.
std::string kind_of(Status status) {
  std::string kind = to_string(status.fault);
  if (status.pool != Pool::none) kind += std::string(": ") + to_string(status.pool);
  if (status.missing != MissingShader::none) kind += std::string(": ") + to_string(status.missing);
  return kind;
}

/// One status of each kind.
Statuses every_kind() {
  Statuses all;
  for (int i = 0; i <= static_cast<int>(Fault::bad_corners); ++i) {
    const auto fault = static_cast<Fault>(i);
    if (fault != Fault::pool_full && fault != Fault::shader_missing) all.emplace_back(fault);
  }
  for (int i = 1; i <= static_cast<int>(Pool::members); ++i)
    all.emplace_back(Fault::pool_full, static_cast<Pool>(i), 0U);
  for (const Pool pool : {Pool::instances, Pool::polygons, Pool::fans, Pool::active, Pool::awake, Pool::fragments,
                          Pool::layers, Pool::members})
    all.emplace_back(Fault::bad_configuration, pool, 0U);
  for (int i = 1; i <= static_cast<int>(MissingShader::mixture); ++i) all.emplace_back(static_cast<MissingShader>(i));
  return all;
}

TEST(ApiFrames, AreDrawnAlikeInBandsOfAnyHeightAndReachEveryStatus) {
  test::Random random(1);
  std::map<std::string, int> told;
  for (int i = 0; i < frames; ++i) {
    Statuses statuses;
    ASSERT_EQ(fault_in(decode_frame(random_bytes(random)), statuses), "") << "frame " << i;
    for (const Status& status : statuses) ++told[kind_of(status)];
  }
  std::string never, counts;
  for (const Status& status : every_kind())
    if (!told.contains(kind_of(status))) never += kind_of(status) + "\n";
  for (const auto& [kind, count] : told) counts += std::to_string(count) + " times " + kind + "\n";
  EXPECT_EQ(never, "") << "is what no call told; what they told:\n" << counts;
}

}  // namespace
}  // namespace spanline::fuzz
