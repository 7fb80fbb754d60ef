#pragma once
#include <memory>

namespace CLI {
class App;
}

namespace spanline::sim {

/// A subcommand: declared to the command line, then run with what was read.
class Command {
 public:
  virtual ~Command() = default;
  /// Declares options; called once.
  virtual void declare(CLI::App& app) = 0;
  /// Does the work. Throws Failure.
  virtual void run() = 0;
  [[nodiscard]] virtual const char* name() const = 0;
  [[nodiscard]] virtual const char* description() const = 0;
};

[[nodiscard]] std::unique_ptr<Command> make_render_command();
[[nodiscard]] std::unique_ptr<Command> make_convert_command();
[[nodiscard]] std::unique_ptr<Command> make_font_command();
[[nodiscard]] std::unique_ptr<Command> make_list_command();
[[nodiscard]] std::unique_ptr<Command> make_view_command();

/// The whole program: reads the command line, runs a command and returns the exit code. Errors are one line on stderr.
int run_command_line(int argc, const char* const* argv);

}  // namespace spanline::sim
