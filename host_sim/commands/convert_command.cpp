#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>

#include "base/failure.hpp"
#include "base/output_file.hpp"
#include "base/standard_streams.hpp"
#include "commands/commands.hpp"
#include "commands/displacement_options.hpp"
#include "commands/highlight_options.hpp"
#include "convert/flash_mesh.hpp"
#include "convert/header_writer.hpp"
#include "convert/memory_report.hpp"
#include "convert/parts_writer.hpp"
#include "convert/texture_writer.hpp"
#include "image/image_file.hpp"
#include "import/model_file.hpp"
#include "scene/scene.hpp"
#include "spanline/model/validate.hpp"

namespace spanline::sim {
namespace {

class ConvertCommand final : public Command {
 public:
  void declare(CLI::App& app) override {
    app.add_option("MODEL", model_, "OBJ, glTF/GLB, PLY or STL; or an image, PNG or JPEG, for a texture")->required();
    app.add_option("-o,--output", output_, "the header")->type_name("mesh.hpp")->required();
    app.add_option("--name", name_, "name of the mesh or texture (by default the header's)")->type_name("NAME");
    app.add_flag("--textured", textured_, "keeps the model's texture coordinates");
    app.add_flag("--materials", materials_, "a mesh, a material and its texture for each of the model's parts");
    app.add_option(
           "--format", format_,
           "of texels: rgb565, rgb565-cutout, argb4444, palette16, palette256 (rgb565; with --materials by alpha)")
        ->type_name("NAME");
    app.add_flag("--mipmap", mip_map_, "with all smaller levels of the texture");
    app.add_flag("--resize", resize_, "makes the image's sides powers of two that a texture may have");
    app.add_option("--wrap", wrap_, "beyond the texture's edge: repeat (default) or clamp")->type_name("repeat|clamp");
    add_displacement_options(app, displacement_, "Displacement");
    add_highlight_options(app, highlights_, "Highlights, with --materials");
    app.add_flag("--bsp", bsp_, "with a BSP tree (not available yet)");
    app.add_option("--simplify", simplify_, "to at most N triangles (not available yet)")->type_name("N");
  }

  void run() override {
    if (bsp_) throw NotAvailable("--bsp");
    if (simplify_) throw NotAvailable("--simplify");
    if (name_ && !is_identifier(*name_)) throw UsageError("--name: '" + *name_ + "' is no name for a C++ object");
    if (output_.empty()) throw UsageError("-o: the name is empty");
    if (same_file(output_, model_)) throw UsageError("-o names the model itself");
    const std::optional<DisplacementArguments> displacement = parse_displacement(displacement_);
    const std::optional<Highlights> highlights = parse_highlights(highlights_);
    if (highlights && !materials_) throw UsageError("--specular and --shininess go with --materials");
    if (is_image_name(model_)) {
      if (displacement) throw UsageError("--displace goes with a model");
      return convert_image();
    }
    if (materials_) return convert_parts(displacement, highlights);
    if (format_ || mip_map_ || resize_ || wrap_)
      throw UsageError("--format, --mipmap, --resize and --wrap go with an image or --materials");
    OutputFile file(output_);
    const Scene scene = load(displacement);
    const CoreMesh mesh = to_valid_mesh(scene);
    file.write(write_header(mesh, name_.value_or(identifier_from(output_)),
                            std::filesystem::path(model_).filename().string()));
    file.close();
    print(memory_report(mesh, measure_need(scene)));
    file.commit();
  }

  [[nodiscard]] const char* name() const override { return "convert"; }
  [[nodiscard]] const char* description() const override {
    return "Turns a model into C++ tables for flash and prints the flash and RAM they need";
  }

 private:
  void convert_image() const {
    if (textured_ || materials_) throw UsageError("--textured and --materials go with a model");
    const TextureOptions options = texture_options();
    const Wrap wrap = wrap_ ? parse_wrap("--wrap", *wrap_) : Wrap::repeat;
    OutputFile file(output_);
    TextureImage texture = read_texture(model_, options);
    texture.shape.wrap_s = texture.shape.wrap_t = wrap;
    file.write(write_texture_header(texture, name_.value_or(identifier_from(output_)),
                                    std::filesystem::path(model_).filename().string()));
    file.close();
    print(texture_report(texture));
    file.commit();
  }

  void convert_parts(const std::optional<DisplacementArguments>& displacement,
                     const std::optional<Highlights>& highlights) const {
    const TextureOptions options = texture_options();
    const std::optional<Wrap> wrap = wrap_ ? std::optional(parse_wrap("--wrap", *wrap_)) : std::nullopt;
    OutputFile file(output_);
    Scene scene = import_model(model_);
    if (displacement) scene = displaced(scene, model_, *displacement);
    if (wrap) set_wrap(scene, *wrap);
    if (highlights) set_highlights(scene, *highlights);
    halve_mirrored_coordinates(scene);
    complete_vertex_normals(scene);
    FlashParts parts;
    try {
      parts = cut_into_parts(scene, options, format_.has_value());
    } catch (const Failure& failure) {
      throw file_failure(model_, failure.what());
    }
    for (const CoreMesh& mesh : parts.meshes) check(mesh);
    file.write(write_parts_header(parts, name_.value_or(identifier_from(output_)),
                                  std::filesystem::path(model_).filename().string()));
    file.close();
    print(parts_report(parts, measure_need(welded(scene))));
    file.commit();
  }

  [[nodiscard]] TextureOptions texture_options() const {
    TextureOptions options{.mip_map = mip_map_, .resize = resize_};
    if (format_) options.format = find_texel_format("--format", *format_);
    return options;
  }

  [[nodiscard]] Scene load(const std::optional<DisplacementArguments>& displacement) const {
    Scene scene = import_model(model_);
    if (displacement) scene = displaced(scene, model_, *displacement);
    if (!textured_)
      scene.texture_points.clear();
    else if (scene.texture_points.empty())
      throw file_failure(model_, "has no texture coordinates");
    complete_vertex_normals(scene);
    complete_polygon_colours(scene);
    return welded(scene);
  }

  [[nodiscard]] CoreMesh to_valid_mesh(const Scene& scene) const {
    CoreMesh mesh;
    try {
      mesh = to_flash_mesh(scene);
    } catch (const Failure& failure) {
      throw file_failure(model_, failure.what());
    }
    check(mesh);
    return mesh;
  }

  void check(const CoreMesh& mesh) const {
    const MeshReport report = validate(mesh.view());
    if (!report.ok())
      throw file_failure(
          model_, std::string("makes no valid mesh: ") + to_string(report.fault) + " at " + std::to_string(report.at));
  }

  std::string model_, output_;
  DisplacementTexts displacement_;
  HighlightTexts highlights_;
  std::optional<std::string> name_, simplify_, format_, wrap_;
  bool bsp_ = false, textured_ = false, materials_ = false, mip_map_ = false, resize_ = false;
};

}  // namespace

std::unique_ptr<Command> make_convert_command() { return std::make_unique<ConvertCommand>(); }

}  // namespace spanline::sim
