#include <CLI/CLI.hpp>
#include <string>

#include "base/standard_streams.hpp"
#include "commands/commands.hpp"
#include "registry/registry.hpp"

namespace spanline::sim {
namespace {

class ListCommand final : public Command {
 public:
  void declare(CLI::App&) override {}
  void run() override {
    std::string text;
    for (const ListEntry& entry : list_entries())
      text += entry.kind + "\t" + entry.name + "\t" + entry.exactness + "\t" + entry.description + "\n";
    print(text);
  }
  [[nodiscard]] const char* name() const override { return "list"; }
  [[nodiscard]] const char* description() const override {
    return "What there is, a line each: kind, name, class, description";
  }
};

}  // namespace

std::unique_ptr<Command> make_list_command() { return std::make_unique<ListCommand>(); }

}  // namespace spanline::sim
