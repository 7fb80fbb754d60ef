#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "base/failure.hpp"
#include "base/output_file.hpp"
#include "base/parse.hpp"
#include "commands/commands.hpp"
#include "convert/font_writer.hpp"
#include "convert/header_writer.hpp"

namespace spanline::sim {
namespace {

class FontCommand final : public Command {
 public:
  void declare(CLI::App& app) override {
    app.add_option("FONT", font_, "TrueType or OpenType")->required();
    app.add_option("-o,--output", output_, "the header")->type_name("font.hpp")->required();
    app.add_option("--pixels", pixels_, "height of an em (14)")->type_name("N");
    app.add_option("--name", name_, "name of the font (by default the header's)")->type_name("NAME");
  }

  void run() override {
    const int pixels = pixels_ ? parse_integer("--pixels", *pixels_, 4, 100) : 14;
    if (name_ && !is_identifier(*name_)) throw UsageError("--name: '" + *name_ + "' is no name for a C++ object");
    if (output_.empty()) throw UsageError("-o: the name is empty");
    if (same_file(output_, font_)) throw UsageError("-o names the font itself");
    OutputFile file(output_);
    file.write(write_font_header(font_, pixels, name_.value_or(identifier_from(output_))));
    file.commit();
  }

  [[nodiscard]] const char* name() const override { return "font"; }
  [[nodiscard]] const char* description() const override { return "Turns a font into C++ tables for flash"; }

 private:
  std::string font_, output_;
  std::optional<std::string> pixels_, name_;
};

}  // namespace

std::unique_ptr<Command> make_font_command() { return std::make_unique<FontCommand>(); }

}  // namespace spanline::sim
