#pragma once
#include <cstdint>

#include "spanline/world/submission_order.hpp"

namespace spanline {

/// Reads a submission order run by run. A run is the submissions of one instance that follow one another.
template <SubmissionOrder Order>
class OrderRuns {
 public:
  explicit OrderRuns(Order& order) : order_(order) { advance(); }

  /// Whether there is a run.
  [[nodiscard]] bool more() const { return more_; }
  /// The number of its instance, which may be one that does not exist.
  [[nodiscard]] std::uint32_t instance() const { return next_.instance; }

  /// Calls `take(submission)` for each submission of the run, and goes on to the next run.
  template <class Take>
  void take_run(Take take) {
    const std::uint32_t number = instance();
    do {
      take(next_);
      advance();
    } while (more_ && instance() == number);
  }

 private:
  void advance() { more_ = order_.next(next_); }

  Order& order_;
  Submission next_;
  bool more_ = false;
};

}  // namespace spanline
