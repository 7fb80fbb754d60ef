#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

#include "panels/complaint.hpp"
#include "panels/panel_model.hpp"

namespace spanline::test {

/// Drives a panel model by hand, with every byte right or wrong as a test wants it.
template <typename Model>
class ModelTest : public ::testing::Test {
 protected:
  template <typename... Arguments>
  explicit ModelTest(Arguments... arguments) : model_(arguments...) {}

  static constexpr std::uint64_t us = 1000;
  static constexpr std::uint64_t ms = 1000 * us;

  void wait(std::uint64_t ns) { now_ns_ += ns; }
  void command(std::uint8_t value) { model_.byte(false, value, now_ns_ += us); }
  void data(std::initializer_list<int> values) {
    for (const int value : values) model_.byte(true, static_cast<std::uint8_t>(value), now_ns_ += us);
  }
  /// Black: what a panel wants before its display goes on.
  void blank(int bytes) {
    for (int i = 0; i < bytes; ++i) model_.byte(true, 0, now_ns_);
  }
  void reset(std::uint64_t low_ns = 1 * ms, std::uint64_t pause_ns = 120 * ms) {
    model_.reset_line(true, now_ns_);
    wait(low_ns);
    model_.reset_line(false, now_ns_);
    wait(pause_ns);
  }

  /// The names of all complaints, in order of appearance.
  [[nodiscard]] std::vector<std::string> complaints() const {
    std::vector<std::string> names;
    for (const sim::Complaint& complaint : model_.complaints()) names.emplace_back(to_string(complaint.kind));
    return names;
  }

  /// Exactly this one kind of complaint was raised.
  void expect_only(sim::ComplaintKind kind) const {
    EXPECT_EQ(complaints(), std::vector<std::string>{to_string(kind)});
  }

  Model model_;
  std::uint64_t now_ns_ = 1 * ms;
};

}  // namespace spanline::test
