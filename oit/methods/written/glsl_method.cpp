// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/methods/written/glsl_method.h"

#include <fmt/format.h>

#include <optional>
#include <variant>

#include "core/error.h"
#include "core/options/split.h"
#include "oit/gl/bindings.h"
#include "oit/methods/written/glsl_file.h"
#include "oit/stage/oit_renderer.h"

namespace pellucid::oit {
namespace {

// Image units that neither locks nor opacities have.
constexpr int free_images[] = {0, 1, 2, 4, 5};
constexpr std::string_view locks = "locks";  // declared by oit/stage/pixel_lock.glsl

RawOptions options_of(const std::string& text) {
  RawOptions options;
  for (const std::string_view part : split(text, ' ')) {
    if (part.empty()) continue;
    const std::size_t equals = part.find('=');
    if (equals == part.npos || equals == 0)
      throw InputError(
          fmt::format("glsl: parameters: '{}'; accepted: NAME=VALUE, with spaces between", part));
    if (!options.emplace(part.substr(0, equals), part.substr(equals + 1)).second)
      throw InputError(
          fmt::format("glsl: parameters: '{}' is given twice", part.substr(0, equals)));
  }
  return options;
}

std::string sampler(const GlslTexture& texture) {
  return fmt::format("{}sampler2D{}", texture.format->whole ? "u" : "",
                     texture.layers > 0 ? "Array" : "");
}

std::string image(const GlslTexture& texture) {
  return fmt::format("{}image2D{}", texture.format->whole ? "u" : "",
                     texture.layers > 0 ? "Array" : "");
}

/// The text with its lines numbered as in its file, whatever its includes are replaced by.
std::string numbered(const std::string& text) {
  std::string result = "#line 1\n";
  int line = 0;
  for (const std::string_view part : split(text, '\n')) {
    ++line;
    result += fmt::format("{}\n", part);
    if (part.starts_with("#include")) result += fmt::format("#line {}\n", line + 1);
  }
  return result;
}

/// A Declaration is what a name of the file becomes in a shader.
struct Declaration {
  std::string_view key;  // of the file: "parameters"
  std::string name, text;
};

/// What of a pass is bound, and how its shader finds it.
class Interface {
 public:
  Interface(const WrittenMethod& method, const GlslPass& pass,
            const std::vector<Texture>& textures) {
    if (!pass.screen) prelude_ = fragment;
    if (pass.screen && pass.into.empty()) prelude_ = composite;
    for (const GlslParameter& parameter : method.parameters)
      declare("parameters", parameter.name,
              fmt::format("uniform {}", parameter.whole ? "int" : "float"));
    for (std::size_t i = 0; i < pass.into.size(); ++i) {
      const GlslTexture& target = method.textures[pass.into[i].first];
      declare("textures", target.name,
              fmt::format("layout(location = {}) out {}", i, target.format->type));
    }
    for (std::size_t i = 0; i < pass.reads.size(); ++i)
      read(method.textures[pass.reads[i]], textures[pass.reads[i]], bindings::own_texture + int(i));
    const int* unit = free_images;
    for (const std::size_t index : pass.images)
      if (method.textures[index].name == locks)
        resources_.add(textures[index].as_image(bindings::locks_image));
      else
        change(method.textures[index], textures[index], *unit++);
  }

  std::string complete(const GlslPass& pass) const {
    std::string text(prelude_);
    for (const Declaration& declaration : declarations_) text += declaration.text;
    return text + numbered(pass.text);
  }
  /// What the program has before the file's names.
  std::string_view prelude() const { return prelude_; }
  const std::vector<Declaration>& declarations() const { return declarations_; }
  const Resources& resources() const { return resources_; }

 private:
  void declare(std::string_view key, const std::string& name, const std::string& type) {
    declarations_.push_back({key, name, fmt::format("{} {};\n", type, name)});
  }

  void read(const GlslTexture& texture, const Texture& data, int unit) {
    declare("textures", texture.name,
            fmt::format("layout(binding = {}) uniform {}", unit, sampler(texture)));
    resources_.add(data.as_texture(unit));
  }

  void change(const GlslTexture& texture, const Texture& data, int unit) {
    declare("textures", texture.name,
            fmt::format("layout(binding = {}, {}) coherent uniform {}", unit, texture.format->name,
                        image(texture)));
    resources_.add(data.as_image(unit));
  }

  static constexpr std::string_view fragment = "#include \"oit/shapes/fragment.glsl\"\n";
  static constexpr std::string_view composite = "#include \"oit/stage/composite.glsl\"\n";

  std::string_view prelude_;
  std::vector<Declaration> declarations_;
  Resources resources_;
};

/// A pass ready to be drawn.
struct ReadyPass {
  std::string step;
  std::variant<GeometryProgram, Program> program;
  std::optional<Framebuffer> target;  // none: the picture
  std::array<Blend, 8> blends{};
  Resources resources;
  bool stores = false;  // into images, which the next pass waits for
};

class GlslMethod final : public OitMethod {
 public:
  GlslMethod(Stage& stage, const GlslOptions& options)
      : stage_(stage),
        file_(options.file),
        method_(read_glsl_method(options.file)),
        specs_(method_.specs()),
        parameters_(options.file, specs_, options_of(options.parameters)) {
    for (GlslTexture& texture : method_.textures) {
      if (!texture.layers_are.empty()) texture.layers = parameters_.integer(texture.layers_are);
      textures_.push_back(stage.target(texture.name, texture.format->format, texture.layers));
    }
    for (const GlslPass& pass : method_.passes) passes_.push_back(ready(pass));
  }

  void draw(Frame& frame) override {
    frame.step("clear", [&] { clear(); });
    for (const ReadyPass& pass : passes_) frame.step(pass.step, [&] { draw(pass, frame); });
  }

  std::vector<std::string> explain() const override {
    return {fmt::format("method: {}; textures: {}; passes: {}",
                        method_.title.empty() ? "without a title" : method_.title,
                        method_.textures.size(), method_.passes.size())};
  }

 private:
  ReadyPass ready(const GlslPass& pass) const {
    const Interface interface(method_, pass, textures_);
    ReadyPass made;
    made.step = pass.step;
    made.resources = interface.resources();
    made.stores = !pass.images.empty();
    if (!pass.into.empty())
      made.target = target_of(pass);
    else if (!pass.screen)
      made.target.emplace(stage_.gl(), stage_.width(), stage_.height());
    made.blends.fill(Blend::replace);
    for (std::size_t i = 0; i < pass.into.size(); ++i) made.blends[i] = pass.into[i].second;
    compile(pass, interface, made);
    return made;
  }

  Framebuffer target_of(const GlslPass& pass) const {
    std::vector<Framebuffer::Attachment> attachments;
    for (const auto& [index, blend] : pass.into) attachments.push_back({textures_[index]});
    return {stage_.gl(), attachments};
  }

  void compile(const GlslPass& pass, const Interface& interface, ReadyPass& made) const {
    const std::string text = interface.complete(pass);
    try {
      if (pass.screen)
        set_parameters(made.program.emplace<Program>(stage_.screen_program(text)));
      else
        set_parameters(made.program.emplace<GeometryProgram>(stage_.geometry_program(text)));
    } catch (const WorkError& error) {
      check_names(pass, interface);
      throw InputError(fmt::format("{}: {}", pass.file.string(), error.what()));
    }
  }

  /// A name that GLSL or the program has is an error of the method's file, at a line that no shader
  /// of its own has. Which names these are the driver knows.
  void check_names(const GlslPass& pass, const Interface& interface) const {
    const std::string prelude(interface.prelude());
    if (!compiles(pass, prelude)) return;
    for (const Declaration& declaration : interface.declarations())
      if (!compiles(pass, prelude + declaration.text))
        throw InputError(fmt::format(
            "{0}: {1}.{2}: the name '{2}' is one that GLSL or the program has; accepted: another "
            "one",
            file_, declaration.key, declaration.name));
  }

  /// What compiles does not link where a shader lacks its functions.
  bool compiles(const GlslPass& pass, const std::string& text) const {
    try {
      if (pass.screen)
        stage_.screen_program(text);
      else
        stage_.geometry_program(text);
    } catch (const WorkError& error) {
      return std::string_view(error.what()).find("does not compile") == std::string_view::npos;
    }
    return true;
  }

  template <class AnyProgram>
  void set_parameters(const AnyProgram& program) const {
    for (const GlslParameter& parameter : method_.parameters)
      if (parameter.whole)
        program.set_if_used(parameter.name, parameters_.integer(parameter.name));
      else
        program.set_if_used(parameter.name, float(parameters_.real(parameter.name)));
  }

  void clear() const {
    for (std::size_t i = 0; i < textures_.size(); ++i)
      if (method_.textures[i].format->whole)
        textures_[i].clear(std::uint32_t(method_.textures[i].clear));
      else
        textures_[i].clear_floats(float(method_.textures[i].clear));
  }

  void draw(const ReadyPass& ready, Frame& frame) const {
    Pass pass(ready.target ? *ready.target : frame.picture(), {Blend::replace}, ready.resources);
    pass.blends = ready.blends;
    if (const auto* program = std::get_if<GeometryProgram>(&ready.program))
      stage_.draw_geometry(pass, *program);
    else
      stage_.draw_screen(pass, std::get<Program>(ready.program));
    if (ready.stores) stage_.gl().MemoryBarrier(GL_ALL_BARRIER_BITS);
  }

  Stage& stage_;
  std::string file_;
  WrittenMethod method_;
  std::vector<ParameterSpec> specs_;
  Parameters parameters_;
  std::vector<Texture> textures_;
  std::vector<ReadyPass> passes_;
};

std::unique_ptr<scene::Renderer> make(const scene::Scene& scene, const Parameters& parameters,
                                      const scene::RenderContext& context) {
  if (!parameters.is_set("file"))
    throw InputError("glsl: file is not given; accepted: glsl:file=METHOD.json");
  return make_oit<GlslMethod, glsl_options>(scene, parameters, context);
}

}  // namespace

const OptionTable<GlslOptions>& glsl_options() {
  static const OptionTable<GlslOptions> table{
      file("file", &GlslOptions::file, "of format pellucid-glsl-method: textures and passes"),
      text("parameters", &GlslOptions::parameters,
           "of the file's own: NAME=VALUE, with spaces between")};
  return table;
}

const scene::MethodRow& glsl_method() {
  static const scene::MethodRow row{.name = "glsl",
                                    .title = "Shaders of a file",
                                    .citation = "the file's",
                                    .equations = "the file's",
                                    .checked_against = "nothing: it is what its file says",
                                    .parameters = glsl_options().specs(),
                                    .promises = {.order_spread = 1},
                                    .bytes_per_pixel = "of the file's textures",
                                    .make = make};
  return row;
}

}  // namespace pellucid::oit
