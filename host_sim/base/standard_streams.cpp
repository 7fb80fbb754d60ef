#include "base/standard_streams.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>

#include "base/failure.hpp"

namespace spanline::sim {

void prepare_streams() {
  std::signal(SIGXFSZ, SIG_IGN);
  // Each takes the lowest number that is free. Nothing can be written to them, as nothing could before.
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) < 0 && open("/dev/null", O_RDONLY) < 0) return;
}

void print(const std::string& text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  if (!written) throw Failure(std::string("standard output cannot be written: ") + std::strerror(errno));
}

void print_message(const std::string& kind, std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.pop_back();
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c == 127; }, ' ');
  std::fprintf(stderr, "spanline: %s: %s\n", kind.c_str(), text.c_str());
}

}  // namespace spanline::sim
