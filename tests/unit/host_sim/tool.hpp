#pragma once
#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "image/picture.hpp"

namespace spanline::sim::test {

/// What a run of the real `spanline` did.
struct ToolRun {
  int exit_code = -1;  ///< −1 if a signal ended it
  std::string output, errors;
};

[[nodiscard]] std::string read_text(const std::filesystem::path& path);
void write_text(const std::filesystem::path& path, const std::string& text);
[[nodiscard]] Picture read_png(const std::filesystem::path& path);

/// Tests with a folder of their own, which is removed afterwards.
class ToolTest : public ::testing::Test {
 protected:
  ToolTest();
  ~ToolTest() override;

  /// A path in the folder.
  [[nodiscard]] std::string in_folder(const std::string& name) const { return (folder_ / name).string(); }
  /// Writes a file into the folder and returns its path.
  std::string make_file(const std::string& name, const std::string& content) const;
  /// Runs the command with these arguments.
  [[nodiscard]] ToolRun run(const std::vector<std::string>& arguments) const;
  /// Runs a line of the shell in the folder; "$SPANLINE" is the command.
  [[nodiscard]] ToolRun shell(const std::string& line) const;
  /// Names in the folder, temporary ones included.
  [[nodiscard]] std::vector<std::string> files() const;

  /// One line on stderr that begins as errors do, nothing written, and this exit code.
  void expect_refused(const ToolRun& run, int exit_code, const std::vector<std::string>& files_before) const;

 private:
  /// Runs a program with these words, the first its path, in the folder or where the test runs.
  [[nodiscard]] ToolRun execute(std::vector<std::string> words, bool in_own_folder) const;

  std::filesystem::path folder_;
};

/// |a − b| of the channel that differs most.
[[nodiscard]] int greatest_difference(Rgb888 a, Rgb888 b);

/// R<<16 | G<<8 | B.
[[nodiscard]] std::uint32_t number_of(Rgb888 pixel);

}  // namespace spanline::sim::test
