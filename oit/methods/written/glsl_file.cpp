// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/methods/written/glsl_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <nlohmann/json.hpp>
#include <set>

#include "core/files/json_node.h"
#include "core/files/output_file.h"
#include "core/options/names.h"
#include "core/options/option_table.h"

namespace pellucid::oit {
namespace {

namespace fs = std::filesystem;

constexpr std::array<GlslFormat, 8> formats{{{"r32f", GL_R32F, "float", false},
                                             {"rg16f", GL_RG16F, "vec2", false},
                                             {"rg32f", GL_RG32F, "vec2", false},
                                             {"rgba16f", GL_RGBA16F, "vec4", false},
                                             {"rgba32f", GL_RGBA32F, "vec4", false},
                                             {"r32ui", GL_R32UI, "uint", true},
                                             {"rg32ui", GL_RG32UI, "uvec2", true},
                                             {"rgba32ui", GL_RGBA32UI, "uvec4", true}}};

struct BlendName {
  std::string_view name;
  Blend blend;
};
constexpr std::array<BlendName, 5> blends{{{"replace", Blend::replace},
                                           {"add", Blend::add},
                                           {"under", Blend::under},
                                           {"over", Blend::over},
                                           {"transmit", Blend::transmit}}};

constexpr double any = std::numeric_limits<double>::max();
constexpr int most_layers = 2048;       // OpenGL promises as many
constexpr std::size_t most_reads = 6;   // texture units from own_texture on
constexpr std::size_t most_images = 5;  // image units of no other family

/// What becomes an identifier of GLSL: letters, digits and single underscores.
void check_name(const JsonNode& node, const std::string& name) {
  const bool fits =
      !name.empty() && !std::isdigit(static_cast<unsigned char>(name[0])) &&
      std::ranges::all_of(name, [](unsigned char c) { return std::isalnum(c) || c == '_'; }) &&
      name.find("__") == name.npos && !name.starts_with("gl_");
  if (!fits) node.fail(fmt::format("the name '{}'; accepted: letters, digits and single _", name));
}

template <class Rows>
const auto& row_of(const JsonNode& node, std::string_view kind, const Rows& rows) {
  return at_place(
      node, [&]() -> const auto& { return find_row(kind, node.string(), rows); });
}

std::string optional_text(const JsonNode& node, std::string_view key) {
  return node.has(key) ? node[key].string() : std::string();
}

class Reader {
 public:
  explicit Reader(const fs::path& path)
      : folder_(path.parent_path()), json_(read_json(path)), root_(path.string(), json_) {}

  WrittenMethod read() {
    root_.accept_keys(
        {"format", "version", "title", "citation", "parameters", "textures", "passes"});
    for (const char* key : {"format", "version", "passes"})
      if (!root_.has(key)) root_.fail(fmt::format("the key '{}' is missing", key));
    root_["format"].one_of({"pellucid-glsl-method"});
    root_["version"].integer(1, 1);
    method_.title = optional_text(root_, "title");
    method_.citation = optional_text(root_, "citation");
    each("parameters", [&](const JsonNode& node, auto& name) { read_parameter(node, name); });
    each("textures", [&](const JsonNode& node, auto& name) { read_texture(node, name); });
    for (const JsonNode& pass : root_["passes"].elements()) read_pass(pass);
    check_last();
    return std::move(method_);
  }

 private:
  /// Calls `read` with each value of an object that may be missing; no name is there twice.
  template <class Read>
  void each(std::string_view key, const Read& read) {
    if (!root_.has(key)) return;
    const JsonNode object = root_[key];
    if (!object.is_object()) object.fail("accepted: an object, by name");
    for (const auto& item : object.value().items()) {
      const JsonNode node = object[item.key()];
      check_name(node, item.key());
      if (!names_.insert(item.key()).second)
        node.fail("a parameter has this name; accepted: another one");
      read(node, item.key());
    }
  }

  void read_parameter(const JsonNode& node, const std::string& name) {
    node.accept_keys({"default", "min", "max", "whole", "unit", "help"});
    if (!node.has("default")) node.fail("the key 'default' is missing");
    GlslParameter parameter;
    parameter.name = name;
    parameter.min = node.has("min") ? node["min"].number(-any, any) : -any;
    parameter.max = node.has("max") ? node["max"].number(-any, any) : any;
    parameter.whole = node.has("whole") && node["whole"].boolean();
    const JsonNode value = node["default"];
    parameter.default_value = number_text(value.number(parameter.min, parameter.max));
    if (parameter.whole) value.integer(-(1 << 24), 1 << 24);
    parameter.unit = optional_text(node, "unit");
    parameter.help = optional_text(node, "help");
    method_.parameters.push_back(std::move(parameter));
  }

  void read_texture(const JsonNode& node, const std::string& name) {
    node.accept_keys({"format", "clear", "layers"});
    if (!node.has("format")) node.fail("the key 'format' is missing");
    GlslTexture texture;
    texture.name = name;
    texture.format = &row_of(node["format"], "format", formats);
    if (node.has("clear"))
      texture.clear = texture.format->whole ? node["clear"].integer(0, 1 << 30)
                                            : node["clear"].number(-any, any);
    if (node.has("layers")) read_layers(node["layers"], texture);
    method_.textures.push_back(std::move(texture));
  }

  void read_layers(const JsonNode& node, GlslTexture& texture) {
    if (!node.is_string()) {
      texture.layers = node.integer(1, most_layers);
      return;
    }
    const GlslParameter& parameter = row_of(node, "parameter", method_.parameters);
    if (!parameter.whole || parameter.min < 1 || parameter.max > most_layers)
      node.fail(
          fmt::format("the parameter '{}'; accepted: one that is whole, of \"min\" 1 and "
                      "\"max\" {} at most",
                      parameter.name, most_layers));
    texture.layers_are = parameter.name;
    texture.layers = 1;  // an array; how many a call tells
  }

  void read_pass(const JsonNode& node) {
    node.accept_keys({"step", "geometry", "screen", "into", "reads", "images"});
    GlslPass pass;
    pass.screen = node.has("screen");
    if (pass.screen == node.has("geometry"))
      node.fail("accepted: one of the keys geometry and screen, the file of a fragment shader");
    const JsonNode shader = node[pass.screen ? "screen" : "geometry"];
    const std::string name = shader.string();
    pass.file = folder_ / name;
    pass.text = at_place(shader, [&] { return read_text(pass.file); });
    pass.step = node.has("step") ? node["step"].string() : fs::path(name).stem().string();
    if (node.has("into")) read_targets(node["into"], pass);
    pass.reads = textures_of(node, "reads", most_reads);
    pass.images = textures_of(node, "images", most_images);
    check_uses(node, pass);
    method_.passes.push_back(std::move(pass));
  }

  std::size_t texture(const JsonNode& node, const std::string& name) const {
    return at_place(node, [&] {
      return std::size_t(&find_row("texture", name, method_.textures) - method_.textures.data());
    });
  }

  void read_targets(const JsonNode& node, GlslPass& pass) const {
    if (!node.is_object()) node.fail("accepted: an object, texture: blend");
    for (const auto& item : node.value().items()) {
      const JsonNode entry = node[item.key()];
      const std::size_t index = texture(entry, item.key());
      const Blend blend = row_of(entry, "blend", blends).blend;
      if (method_.textures[index].layers > 0)
        entry.fail("it has layers; accepted: a texture without, arrays are \"images\"");
      if (method_.textures[index].format->whole && blend != Blend::replace)
        entry.fail("whole numbers are not blended; accepted: replace");
      pass.into.emplace_back(index, blend);
    }
    if (pass.into.size() > std::tuple_size_v<decltype(Pass::blends)>)
      node.fail("accepted: 8 textures at most");
  }

  std::vector<std::size_t> textures_of(const JsonNode& node, std::string_view key,
                                       std::size_t most) const {
    std::vector<std::size_t> found;
    if (!node.has(key)) return found;
    for (const JsonNode& element : node[key].elements())
      found.push_back(texture(element, element.string()));
    if (found.size() > most) node[key].fail(fmt::format("accepted: {} textures at most", most));
    return found;
  }

  /// OpenGL leaves open what a pass reads of a texture that it draws into.
  void check_uses(const JsonNode& node, const GlslPass& pass) const {
    std::set<std::size_t> used;
    const auto use = [&](std::size_t index) {
      if (!used.insert(index).second)
        node.fail(fmt::format("'{}' is used twice; accepted: one of into, reads and images",
                              method_.textures[index].name));
    };
    for (const auto& [index, blend] : pass.into) use(index);
    for (const std::size_t index : pass.reads) use(index);
    for (const std::size_t index : pass.images) use(index);
    if (!pass.screen && pass.into.empty() && pass.images.empty())
      node.fail("it leaves nothing behind; accepted: \"into\" or \"images\"");
  }

  void check_last() const {
    const auto& passes = method_.passes;
    const auto draws_picture = [](const GlslPass& pass) {
      return pass.screen && pass.into.empty();
    };
    if (passes.empty() || !draws_picture(passes.back()))
      root_["passes"].fail("the last one has to draw the picture: a \"screen\" without \"into\"");
  }

  fs::path folder_;
  nlohmann::json json_;
  JsonNode root_;
  WrittenMethod method_;
  std::set<std::string> names_;
};

}  // namespace

std::vector<ParameterSpec> WrittenMethod::specs() const {
  std::vector<ParameterSpec> specs;
  for (const GlslParameter& parameter : parameters)
    specs.push_back(
        {.name = parameter.name,
         .kind = parameter.whole ? ParameterSpec::Kind::integer : ParameterSpec::Kind::real,
         .default_value = parameter.default_value,
         .min = parameter.min,
         .max = parameter.max,
         .unit = parameter.unit,
         .help = parameter.help});
  return specs;
}

WrittenMethod read_glsl_method(const fs::path& path) { return Reader(path).read(); }

}  // namespace pellucid::oit
