#include "base/output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>

#include "base/failure.hpp"

namespace spanline::sim {
namespace {

namespace fs = std::filesystem;

/// Temporaries that a signal must remove. A handler may only touch what needs no lock: fixed buffers and flags.
struct Slot {
  std::atomic<bool> used{false};
  std::array<char, 4096> path{};
};
std::array<Slot, 8> slots;

extern "C" void remove_temporaries(int signal_number) {
  for (Slot& slot : slots)
    if (slot.used) unlink(slot.path.data());
  std::signal(signal_number, SIG_DFL);
  std::raise(signal_number);
}

int register_temporary(const std::string& path) {
  for (const int signal_number : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) {
    struct sigaction now {};
    if (sigaction(signal_number, nullptr, &now) == 0 && now.sa_handler == SIG_DFL)
      std::signal(signal_number, remove_temporaries);
  }
  for (std::size_t i = 0; i < slots.size(); ++i) {
    if (slots[i].used || path.size() >= slots[i].path.size()) continue;
    std::memcpy(slots[i].path.data(), path.c_str(), path.size() + 1);
    slots[i].used = true;
    return static_cast<int>(i);
  }
  return -1;
}

std::string system_message() { return std::strerror(errno); }

std::string resolved(const std::string& path) {
  std::error_code error;
  const fs::path whole = fs::weakly_canonical(fs::absolute(path, error), error);
  return error ? path : whole.string();
}

}  // namespace

OutputFile::OutputFile(std::string path) : path_(std::move(path)), target_(resolved(path_)) {
  struct stat status {};
  const bool exists = stat(path_.c_str(), &status) == 0;
  if (path_.empty()) throw Failure("the output file has no name");
  if (exists && S_ISDIR(status.st_mode)) throw file_failure(path_, "cannot be written: it is a folder");
  if (path_.ends_with('/')) throw file_failure(path_, "cannot be written: that names a folder");
  if (exists && !S_ISREG(status.st_mode)) {
    open_target(O_WRONLY);
    return;
  }
  if (exists && access(path_.c_str(), W_OK) != 0) throw file_failure(path_, "cannot be written: " + system_message());
  static int count = 0;
  const std::string name = ".spanline-" + std::to_string(getpid()) + "-" + std::to_string(++count) + ".part";
  temporary_ = (fs::path(target_).parent_path() / name).string();
  open_target(O_WRONLY | O_CREAT | O_EXCL);
  slot_ = register_temporary(temporary_);
  // A temporary left readable as new files are; an old target keeps its own mode.
  if (exists) fchmod(descriptor_, status.st_mode & 07777);
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  remove_temporary();
}

void OutputFile::open_target(int flags) {
  const std::string& name = temporary_.empty() ? path_ : temporary_;
  descriptor_ = open(name.c_str(), flags | O_CLOEXEC, 0666);
  if (descriptor_ >= 0) return;
  const std::string reason = system_message();
  temporary_.clear();
  throw file_failure(path_, "cannot be written: " + reason);
}

void OutputFile::write(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw file_failure(path_, "cannot be written: " + system_message());
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

void OutputFile::close() {
  const int descriptor = descriptor_;
  descriptor_ = -1;
  if (descriptor >= 0 && ::close(descriptor) != 0) throw file_failure(path_, "cannot be written: " + system_message());
}

void OutputFile::commit() {
  close();
  if (temporary_.empty()) return;
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0)
    throw file_failure(path_, "cannot be written: " + system_message());
  temporary_.clear();
  if (slot_ >= 0) slots[static_cast<std::size_t>(slot_)].used = false;
  slot_ = -1;
}

void OutputFile::remove_temporary() {
  if (temporary_.empty()) return;
  unlink(temporary_.c_str());
  temporary_.clear();
  if (slot_ >= 0) slots[static_cast<std::size_t>(slot_)].used = false;
  slot_ = -1;
}

bool same_file(const std::string& a, const std::string& b) { return resolved(a) == resolved(b); }

}  // namespace spanline::sim
