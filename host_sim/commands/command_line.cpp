#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdio>
#include <new>
#include <span>
#include <string>

#include "base/failure.hpp"
#include "commands/commands.hpp"
#include "spanline/version.hpp"

namespace spanline::sim {
namespace {

/// One line whatever the message holds: file names may have control characters.
int report(std::string message, int exit_code) {
  while (!message.empty() && (message.back() == '\n' || message.back() == '\r')) message.pop_back();
  std::replace_if(
      message.begin(), message.end(), [](unsigned char c) { return c < ' ' || c == 127; }, ' ');
  std::fprintf(stderr, "spanline: error: %s\n", message.c_str());
  return exit_code;
}

void declare_all(CLI::App& app, std::span<const std::unique_ptr<Command>> commands) {
  app.set_version_flag("--version", std::string("spanline ") + version);
  app.require_subcommand(1);
  for (const auto& command : commands) {
    CLI::App* subcommand = app.add_subcommand(command->name(), command->description());
    command->declare(*subcommand);
    subcommand->final_callback([&command] { command->run(); });
  }
}

/// CLI11 would say that a subcommand is missing where it does not know the one given.
void check_command(std::span<const std::unique_ptr<Command>> commands, int argc, const char* const* argv) {
  std::string names;
  if (argc > 1 && argv[1][0] == '-') return;
  for (const auto& command : commands) {
    if (argc > 1 && std::string(argv[1]) == command->name()) return;
    names += (names.empty() ? "" : ", ") + std::string(command->name());
  }
  if (argc <= 1) throw UsageError("no command given; there is " + names + " (spanline --help)");
  throw UsageError("'" + std::string(argv[1]) + "' is no command; there is " + names);
}

}  // namespace

int run_command_line(int argc, const char* const* argv) {
  CLI::App app("Draws 3D models as a microcontroller would: integers alone, scan line by scan line.", "spanline");
  const std::array<std::unique_ptr<Command>, 5> commands{
      make_render_command(), make_view_command(), make_convert_command(), make_font_command(), make_list_command()};
  try {
    check_command(commands, argc, argv);
    declare_all(app, commands);
    app.parse(argc, argv);
    if (std::fflush(stdout) != 0) return report("standard output cannot be written", 1);
    return 0;
  } catch (const CLI::Success& success) {
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    return report(error.what(), 2);
  } catch (const Failure& failure) {
    return report(failure.what(), failure.exit_code());
  } catch (const std::bad_alloc&) {
    return report("out of memory", 1);
  } catch (const std::exception& exception) {
    return report(exception.what(), 1);
  }
}

}  // namespace spanline::sim
