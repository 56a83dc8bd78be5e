// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/study/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "compare/measures/further_measures.h"
#include "compare/methods/sweep.h"
#include "core/error.h"
#include "core/files/json_node.h"
#include "core/options/names.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;

constexpr int max_repeats = 1000;
constexpr int max_side = 1 << 14;  // of a crop, as of a picture
constexpr std::size_t max_calls = 10000;

/// A parameter's value as it would stand on the command line.
std::string option_text(const JsonNode& node) {
  const nlohmann::json& value = node.value();
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>() ? "on" : "off";
  if (value.is_number()) return value.dump();
  node.fail(value.dump() + "; accepted: a number, text, true, false, or an array of these");
}

std::vector<std::string> option_values(const JsonNode& node) {
  if (!node.is_array()) return {option_text(node)};
  std::vector<std::string> values;
  for (const JsonNode& element : node.elements()) values.push_back(option_text(element));
  if (values.empty()) node.fail("[]; accepted: at least one value");
  return values;
}

/// What an entry of a list of calls can name, and the key of its name in an object.
struct Catalogue {
  std::string_view kind;
  std::span<const scene::MethodRow> rows;
};

MethodCall make_call(const JsonNode& node, std::string_view name, const RawOptions& options,
                     const Catalogue& catalogue) {
  try {
    const scene::MethodRow& row = find_row(catalogue.kind, name, catalogue.rows);
    return {&row, Parameters(row.name, row.parameters, options)};
  } catch (const InputError& error) {
    node.fail(error.what());
  }
}

std::vector<MethodCall> calls_of_text(const JsonNode& node, const Catalogue& catalogue) {
  NameAndOptions parsed;
  try {
    parsed = parse_name_and_options(node.string());
  } catch (const InputError& error) {
    node.fail(error.what());
  }
  return {make_call(node, parsed.name, parsed.options, catalogue)};
}

/// {"method": "*", "except": [NAME, …]}
std::vector<MethodCall> calls_but(const JsonNode& node, const Catalogue& catalogue) {
  node.accept_keys({catalogue.kind, "except"});
  std::set<std::string_view> except;
  for (const JsonNode& element : node["except"].elements())
    except.insert(at_place(element, [&]() -> std::string_view {
      return find_row(catalogue.kind, element.string(), catalogue.rows).name;
    }));
  std::vector<MethodCall> calls = every_method(catalogue.rows);
  std::erase_if(calls, [&](const MethodCall& call) { return except.contains(call.row->name); });
  return calls;
}

std::vector<MethodCall> calls_of_object(const JsonNode& node, const Catalogue& catalogue) {
  if (node[catalogue.kind].string() == "*") return calls_but(node, catalogue);
  std::vector<RawOptions> sets(1);
  for (const auto& item : node.value().items()) {
    if (item.key() == catalogue.kind) continue;
    sets = crossed(sets, item.key(), option_values(node[item.key()]));
    if (sets.size() > max_calls) node.fail(fmt::format("more than {} combinations", max_calls));
  }
  std::vector<MethodCall> calls;
  calls.reserve(sets.size());
  for (const RawOptions& options : sets)
    calls.push_back(make_call(node, node[catalogue.kind].string(), options, catalogue));
  return calls;
}

std::vector<MethodCall> read_calls(const JsonNode& node, const Catalogue& catalogue) {
  if (node.is_string() && node.string() == "*") return every_method(catalogue.rows);
  if (node.is_string()) return calls_of_text(node, catalogue);
  if (node.is_object()) return calls_of_object(node, catalogue);
  node.fail(
      fmt::format("accepted: \"NAME[:key=value,…]\", \"*\" for every {0} in all its settings, or "
                  "{{\"{0}\": NAME, key: value or [values], …}}",
                  catalogue.kind));
}

MethodCall read_reference(const JsonNode& node, const Catalogue& catalogue) {
  std::vector<MethodCall> calls = read_calls(node, catalogue);
  if (calls.size() != 1) node.fail("a sweep; accepted: one method with one set of parameters");
  return calls.front();
}

/// Each call once; the reference, which has its own cell, not at all.
void add_calls(const JsonNode& node, const Catalogue& catalogue, Study& study) {
  std::set<std::string> seen{study.reference.text()};
  for (const MethodCall& call : study.methods) seen.insert(call.text());
  for (const JsonNode& element : node.elements())
    for (MethodCall& call : read_calls(element, catalogue))
      if (seen.insert(call.text()).second) study.methods.push_back(std::move(call));
}

/// A scene that is not there, or is something else, is found before hours of work.
fs::path read_scene_path(const JsonNode& node, const fs::path& base) {
  fs::path path = (base / node.string()).lexically_normal();
  if (!fs::is_regular_file(path))
    node.fail(fmt::format("'{}' is not a file; accepted: a scene file, relative to the study",
                          path.string()));
  const nlohmann::json scene = read_json(path);
  JsonNode(path.string(), scene)["format"].one_of({"pellucid-scene"});
  return path;
}

std::vector<fs::path> read_scenes(const JsonNode& node, const fs::path& base) {
  std::vector<fs::path> scenes;
  std::set<std::string> names;
  for (const JsonNode& element : node.elements()) {
    scenes.push_back(read_scene_path(element, base));
    if (!names.insert(scene_name(scenes.back())).second)
      element.fail(fmt::format("a second scene named '{}'; accepted: scenes of different names",
                               scene_name(scenes.back())));
  }
  if (scenes.empty()) node.fail("[]; accepted: at least one scene");
  return scenes;
}

Crop read_crop(const JsonNode& node) {
  const std::vector<JsonNode> numbers = node.elements();
  if (numbers.size() != 4) node.fail("accepted: [x, y, width, height] in pixels");
  return {numbers[0].integer(0, max_side), numbers[1].integer(0, max_side),
          numbers[2].integer(1, max_side), numbers[3].integer(1, max_side)};
}

std::vector<Pixel> read_pixels(const JsonNode& node) {
  std::vector<Pixel> pixels;
  for (const JsonNode& element : node.elements()) {
    const std::vector<JsonNode> numbers = element.elements();
    if (numbers.size() != 2) element.fail("accepted: [column, row] from the top left");
    pixels.push_back({numbers[0].integer(0, max_side), numbers[1].integer(0, max_side)});
  }
  return pixels;
}

/// {SCENE: what `read` makes of it, …}
template <class Read>
auto read_by_scene(const JsonNode& node, const std::vector<std::string>& names, const Read& read) {
  std::map<std::string, decltype(read(node))> by_scene;
  for (const auto& item : node.value().items()) {
    if (std::find(names.begin(), names.end(), item.key()) == names.end())
      node.fail(unknown_name("scene", item.key(),
                             std::vector<std::string_view>(names.begin(), names.end())));
    by_scene.emplace(item.key(), read(node[item.key()]));
  }
  return by_scene;
}

std::vector<std::string> read_measures(const JsonNode& node) {
  std::vector<std::string> names;
  for (const JsonNode& element : node.elements())
    names.emplace_back(at_place(element, [&]() -> std::string_view {
      return find_row("measure", element.string(), further_measures()).name;
    }));
  return names;
}

/// The text of a call that the study has.
std::string read_known_call(const JsonNode& node, const Study& study) {
  std::vector<std::string> texts{study.reference.text()};
  for (const MethodCall& call : study.methods) texts.push_back(call.text());
  const std::string text = node.string();
  if (std::find(texts.begin(), texts.end(), text) == texts.end())
    node.fail(
        unknown_name("call", text, std::vector<std::string_view>(texts.begin(), texts.end())));
  return text;
}

std::vector<std::string> read_group(const JsonNode& node, const Study& study) {
  if (!node.is_array()) return {read_known_call(node, study)};
  std::vector<std::string> group;
  for (const JsonNode& element : node.elements()) group.push_back(read_known_call(element, study));
  return group;
}

Claim read_claim(const JsonNode& node, const Study& study) {
  node.accept_keys({"claim", "by", "order"});
  Claim claim{node["claim"].string(), nullptr, {}};
  claim.by = &at_place(node["by"], [&]() -> const Column& {
    return find_row("number", node["by"].string(), columns());
  });
  if (claim.by->better == Better::neither)
    node["by"].fail(fmt::format("'{}': no way is better", claim.by->name));
  for (const JsonNode& element : node["order"].elements())
    claim.order.push_back(read_group(element, study));
  if (claim.order.size() < 2) node["order"].fail("accepted: at least two calls, the best first");
  return claim;
}

PublishedCost read_cost(const JsonNode& node, const Study& study,
                        std::span<const std::string> steps) {
  node.accept_keys({"scene", "method", "ms", "bytes", "steps"});
  const std::vector<std::string> scenes = scene_names(study);
  PublishedCost cost{node["scene"].string(), read_known_call(node["method"], study), 0, {}, {}};
  if (std::find(scenes.begin(), scenes.end(), cost.scene) == scenes.end())
    node["scene"].fail(unknown_name("scene", cost.scene,
                                    std::vector<std::string_view>(scenes.begin(), scenes.end())));
  constexpr double most = 1e15;
  cost.milliseconds = node["ms"].number(1e-6, most);
  if (node.has("bytes")) cost.bytes = node["bytes"].number(0, most);
  if (!node.has("steps")) return cost;
  for (const JsonNode& step : node["steps"].elements()) cost.steps.push_back(step.number(0, most));
  if (cost.steps.size() != steps.size())
    node["steps"].fail(fmt::format("{} times; accepted: one for each of the {} steps",
                                   cost.steps.size(), steps.size()));
  return cost;
}

PublishedCosts read_published(const JsonNode& node, const Study& study) {
  node.accept_keys({"machine", "steps", "rows"});
  PublishedCosts costs{node["machine"].string(), {}, {}};
  if (node.has("steps"))
    for (const JsonNode& step : node["steps"].elements()) costs.steps.push_back(step.string());
  for (const JsonNode& row : node["rows"].elements())
    costs.rows.push_back(read_cost(row, study, costs.steps));
  return costs;
}

Study read_study(const JsonNode& root, const fs::path& file, const Catalogue& methods,
                 const Catalogue& integrators) {
  root["format"].one_of({"pellucid-study"});
  root["version"].integer(1, 1);
  root.accept_keys({"format", "version", "title", "source", "scenes", "reference",
                    "reference_scene", "integrators", "methods", "repeats", "crops", "claims",
                    "measures", "probes", "published"});
  Study study;
  study.name = file.stem().string();
  study.file = file;
  study.title = root.has("title") ? root["title"].string() : study.name;
  if (root.has("source")) study.source = root["source"].string();
  study.scenes = read_scenes(root["scenes"], file.parent_path());
  if (root.has("reference_scene"))
    study.reference_scene = read_scene_path(root["reference_scene"], file.parent_path());
  study.reference = read_reference(root["reference"], methods);
  if (root.has("integrators")) add_calls(root["integrators"], integrators, study);
  if (root.has("methods") || !root.has("integrators")) add_calls(root["methods"], methods, study);
  if (root.has("repeats")) study.repeats = root["repeats"].integer(1, max_repeats);
  if (root.has("crops")) study.crops = read_by_scene(root["crops"], scene_names(study), read_crop);
  if (root.has("probes"))
    study.probes = read_by_scene(root["probes"], scene_names(study), read_pixels);
  if (root.has("measures")) study.measures = read_measures(root["measures"]);
  if (root.has("claims"))
    for (const JsonNode& element : root["claims"].elements())
      study.claims.push_back(read_claim(element, study));
  if (root.has("published")) study.published = read_published(root["published"], study);
  return study;
}

}  // namespace

std::string scene_name(const fs::path& scene) { return scene.stem().string(); }

std::vector<std::string> scene_names(const Study& study) {
  std::vector<std::string> names;
  names.reserve(study.scenes.size());
  for (const fs::path& scene : study.scenes) names.push_back(scene_name(scene));
  return names;
}

Study load_study(const fs::path& file, std::span<const scene::MethodRow> methods,
                 std::span<const scene::MethodRow> integrators) {
  const nlohmann::json json = read_json(file);
  return read_study(JsonNode(file.string(), json), file, {"method", methods},
                    {"integrator", integrators});
}

}  // namespace pellucid::compare
