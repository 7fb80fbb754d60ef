#include "import/isolated.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <new>
#include <span>

#include "base/failure.hpp"
#include "base/progress.hpp"

namespace spanline::sim {
namespace {

constexpr rlim_t seconds_limit = 600;

/// The first byte that the child sends.
constexpr std::byte tag_result{'R'};
constexpr std::byte tag_error{'E'};

void limit(__rlimit_resource_t resource, rlim_t value) {
  const rlimit bound{value, value};
  setrlimit(resource, &bound);
}

void confine() {
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) std::signal(number, SIG_DFL);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, seconds_limit);
#if !defined(SPANLINE_SANITIZERS)
  // AddressSanitizer reserves terabytes of address space that it never touches.
  limit(RLIMIT_AS, rlim_t{16} << 30);
#endif
  // What a library prints would break the promise of one line.
  const int nowhere = open("/dev/null", O_RDWR);
  if (nowhere < 0) return;
  for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, standard);
}

bool send(int descriptor, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return true;
}

void send_error(int descriptor, std::string_view message) {
  send(descriptor, {&tag_error, 1});
  send(descriptor, std::as_bytes(std::span(message.data(), message.size())));
}

[[noreturn]] void run_child(int descriptor, const std::function<std::vector<std::byte>()>& work) {
  confine();
  try {
    const std::vector<std::byte> bytes = work();
    if (send(descriptor, {&tag_result, 1})) send(descriptor, bytes);
  } catch (const std::bad_alloc&) {
    send_error(descriptor, "cannot be read: it asks for too much memory");
  } catch (const std::exception& exception) {
    send_error(descriptor, exception.what());
  } catch (...) {
    send_error(descriptor, "cannot be read");
  }
  _exit(0);  // without destructors and exit handlers: those belong to the parent
}

std::vector<std::byte> receive(int descriptor, const std::string& title) {
  Progress progress(title);
  std::vector<std::byte> bytes;
  std::array<std::byte, 65536> block;
  for (;;) {
    pollfd waiting{descriptor, POLLIN, 0};
    progress.show(0, 0);
    if (poll(&waiting, 1, 200) == 0) continue;
    const ssize_t count = read(descriptor, block.data(), block.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return bytes;
    bytes.insert(bytes.end(), block.begin(), block.begin() + count);
  }
}

std::string verdict(int status) {
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) return "cannot be read: it takes too long";
  return "cannot be read: the importer broke down on it";
}

}  // namespace

IsolatedResult run_isolated(const std::string& title, const std::function<std::vector<std::byte>()>& work) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw Failure(std::string("no pipe: ") + std::strerror(errno));
  const pid_t child = fork();
  if (child < 0) throw Failure(std::string("no process: ") + std::strerror(errno));
  if (child == 0) run_child(ends[1], work);
  close(ends[1]);
  std::vector<std::byte> bytes = receive(ends[0], title);
  close(ends[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (bytes.empty() || !WIFEXITED(status) || WEXITSTATUS(status) != 0) return {{}, verdict(status)};
  const std::byte tag = bytes.front();
  bytes.erase(bytes.begin());
  if (tag == tag_result) return {std::move(bytes), {}};
  std::string error(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return {{}, error.empty() ? "cannot be read" : std::move(error)};
}

}  // namespace spanline::sim
