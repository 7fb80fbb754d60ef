#include <CLI/CLI.hpp>
#include <cstdio>

#include "commands/commands.hpp"
#include "registry/registry.hpp"

namespace spanline::sim {
namespace {

class ListCommand final : public Command {
 public:
  void declare(CLI::App&) override {}
  void run() override {
    for (const ListEntry& entry : list_entries())
      std::printf("%s\t%s\t%s\t%s\n", entry.kind.c_str(), entry.name.c_str(), entry.exactness.c_str(),
                  entry.description.c_str());
  }
  [[nodiscard]] const char* name() const override { return "list"; }
  [[nodiscard]] const char* description() const override {
    return "What there is, a line each: kind, name, class, description";
  }
};

}  // namespace

std::unique_ptr<Command> make_list_command() { return std::make_unique<ListCommand>(); }

}  // namespace spanline::sim
