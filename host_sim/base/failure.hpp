#pragma once
#include <stdexcept>
#include <string>

namespace spanline::sim {

/// Why a command ends early: one line for stderr and the process's exit code.
class Failure : public std::runtime_error {
 public:
  /// The work failed: exit 1. `what` names the file and what is wrong with it.
  explicit Failure(const std::string& what) : Failure(what, 1) {}
  [[nodiscard]] int exit_code() const { return exit_code_; }

 protected:
  Failure(const std::string& what, int exit_code) : std::runtime_error(what), exit_code_(exit_code) {}

 private:
  int exit_code_;
};

/// Wrong usage: exit 2.
class UsageError : public Failure {
 public:
  explicit UsageError(const std::string& what) : Failure(what, 2) {}
};

/// A part of the command line that a later version brings: exit 2.
class NotAvailable : public UsageError {
 public:
  explicit NotAvailable(const std::string& what) : UsageError(what + ": not available yet") {}
};

/// "PATH: what".
[[nodiscard]] inline Failure file_failure(const std::string& path, const std::string& what) {
  return Failure(path + ": " + what);
}

}  // namespace spanline::sim
