#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace spanline::sim {

/// A file that appears whole or not at all: bytes go to a temporary file beside the target, and `commit` renames it.
///
/// The constructor already finds out whether the target can be written, before any long work. A target that is not a
/// regular file (/dev/null, a pipe) is written directly. Temporaries are removed by the destructor, and when SIGINT,
/// SIGTERM, SIGHUP or SIGPIPE ends the process. All functions throw Failure with the target's name.
class OutputFile {
 public:
  explicit OutputFile(std::string path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::span<const std::byte> bytes);
  void write(std::string_view text) { write(std::as_bytes(std::span(text.data(), text.size()))); }
  /// Everything is on its way to the disk; only `commit` may follow.
  void close();
  void commit();

  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  void open_target(int flags);
  void remove_temporary();

  std::string path_;       ///< as the user wrote it, for messages
  std::string target_;     ///< with symbolic links resolved
  std::string temporary_;  ///< empty if the target is written directly
  int descriptor_ = -1;
  int slot_ = -1;  ///< in the table that the signal handler cleans up
};

/// True if both paths name the same file, whether it exists or not.
[[nodiscard]] bool same_file(const std::string& a, const std::string& b);

}  // namespace spanline::sim
