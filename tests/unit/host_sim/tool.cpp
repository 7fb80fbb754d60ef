#include "tool.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "image/png.hpp"

namespace spanline::sim::test {

namespace fs = std::filesystem;

std::string read_text(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

void write_text(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

Picture read_png(const fs::path& path) {
  const std::string bytes = read_text(path);
  return decode_png(std::as_bytes(std::span(bytes.data(), bytes.size())));
}

ToolTest::ToolTest() {
  std::string name = (fs::temp_directory_path() / "spanline-test-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  folder_ = name;
}

ToolTest::~ToolTest() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

std::string ToolTest::make_file(const std::string& name, const std::string& content) const {
  write_text(folder_ / name, content);
  return in_folder(name);
}

ToolRun ToolTest::run(const std::vector<std::string>& arguments) const {
  std::vector<std::string> words{SPANLINE_COMMAND};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return execute(words, false);
}

ToolRun ToolTest::shell(const std::string& line) const {
  return execute({"/bin/sh", "-c", std::string("SPANLINE='") + SPANLINE_COMMAND + "'; " + line}, true);
}

ToolRun ToolTest::execute(std::vector<std::string> words, bool in_own_folder) const {
  // Beside the folder, so that the streams are not among its files.
  const std::string out = folder_.string() + ".out", err = folder_.string() + ".err";
  const pid_t child = fork();
  if (child == 0) {
    dup2(open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
    dup2(open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
    if (in_own_folder && chdir(folder_.c_str()) != 0) _exit(127);
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    execv(pointers[0], pointers.data());
    _exit(127);
  }
  int status = 0;
  waitpid(child, &status, 0);
  const ToolRun result{WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_text(out), read_text(err)};
  fs::remove(out);
  fs::remove(err);
  return result;
}

std::vector<std::string> ToolTest::files() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder_)) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

void ToolTest::expect_refused(const ToolRun& run, int exit_code, const std::vector<std::string>& files_before) const {
  EXPECT_EQ(run.exit_code, exit_code);
  EXPECT_EQ(run.output, "");
  EXPECT_TRUE(run.errors.starts_with("spanline: error: ")) << run.errors;
  EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
  EXPECT_TRUE(run.errors.ends_with('\n'));
  EXPECT_EQ(files(), files_before);
}

int greatest_difference(Rgb888 a, Rgb888 b) {
  return std::max({std::abs(a.red - b.red), std::abs(a.green - b.green), std::abs(a.blue - b.blue)});
}

std::uint32_t number_of(Rgb888 pixel) {
  return std::uint32_t{pixel.red} << 16 | std::uint32_t{pixel.green} << 8 | pixel.blue;
}

}  // namespace spanline::sim::test
