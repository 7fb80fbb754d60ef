#pragma once
#include <chrono>
#include <string>

namespace spanline::sim {

/// A line on the terminal that says how far long work has come; silent when stderr is no terminal or the work is done
/// within a second.
class Progress {
 public:
  explicit Progress(std::string what) : what_(std::move(what)), start_(std::chrono::steady_clock::now()) {}
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `done` of `total` steps; a total of 0 means that nobody knows.
  void show(std::size_t done, std::size_t total);
  void clear();

 private:
  std::string what_;
  std::chrono::steady_clock::time_point start_;
  std::chrono::steady_clock::time_point last_{};
  bool shown_ = false;
};

}  // namespace spanline::sim
