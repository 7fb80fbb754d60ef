#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace spanline::sim {

/// What came back from another process: bytes, or an error that is not empty.
struct IsolatedResult {
  std::vector<std::byte> bytes;
  std::string error;
};

/// Runs `work` in a child process with bounded time and memory, and hands its bytes back. An exception's message, a
/// crash or a run beyond the limits comes back as `error`. `title` stands beside the progress of long work.
///
/// Call it while the process has one thread.
[[nodiscard]] IsolatedResult run_isolated(const std::string& title,
                                          const std::function<std::vector<std::byte>()>& work);

}  // namespace spanline::sim
