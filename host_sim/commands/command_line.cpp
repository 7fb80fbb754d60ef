#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <new>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "base/failure.hpp"
#include "base/standard_streams.hpp"
#include "commands/commands.hpp"
#include "spanline/version.hpp"

namespace spanline::sim {
namespace {

int report(const std::string& message, int exit_code) {
  print_message("error", message);
  return exit_code;
}

/// The command line's words, last first as CLI11 takes them. `-o=NAME` is what `--output=NAME` is, which the library
/// would read as the name "=NAME"; and a value that is empty after its equals sign is empty, where the library would
/// take the next word.
std::vector<std::string> words_of(int argc, const char* const* argv) {
  std::vector<std::string> words;
  bool options = true;
  for (int i = 1; i < argc; ++i) {
    std::string word = argv[i];
    if (word == "--") options = false;
    if (options && word.starts_with("-o=")) word = "--output" + word.substr(2);
    const bool empty = options && word.starts_with("--") && word.find('=') == word.size() - 1;
    if (empty) word.pop_back();
    words.push_back(word);
    if (empty) words.emplace_back();
  }
  std::reverse(words.begin(), words.end());
  return words;
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
  prepare_streams();
  CLI::App app("Draws 3D models as a microcontroller would: integers alone, scan line by scan line.", "spanline");
  const std::array<std::unique_ptr<Command>, 5> commands{
      make_render_command(), make_view_command(), make_convert_command(), make_font_command(), make_list_command()};
  try {
    check_command(commands, argc, argv);
    declare_all(app, commands);
    try {
      app.parse(words_of(argc, argv));
    } catch (const CLI::Success& success) {
      std::ostringstream text, errors;
      app.exit(success, text, errors);
      print(text.str());
    }
    return 0;
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
