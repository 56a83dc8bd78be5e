// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/study/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "compare/measures/study_measures.h"
#include "compare/methods/optimize_opacities.h"
#include "compare/study/check_scenes.h"
#include "compare/study/needs.h"
#include "compare/study/read_calls.h"
#include "compare/study/read_given.h"
#include "compare/study/read_settings.h"
#include "compare/study/read_source.h"
#include "core/error.h"
#include "core/files/files_read.h"
#include "core/files/json_node.h"
#include "core/options/names.h"
#include "core/options/option_table.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;

constexpr int max_side = 1 << 14;  // of a crop, as of a picture

/// Two pictures from elsewhere of one name would be one row.
void add_given(const JsonNode& element, const Catalogue& catalogue, std::set<std::string>& seen,
               Study& study) {
  MethodCall call = read_given(element, study.file.parent_path(), catalogue);
  if (!seen.insert(call.text()).second)
    element.fail(fmt::format("a second '{}'; accepted: another name", call.text()));
  study.methods.push_back(std::move(call));
}

bool is_star(const JsonNode& node, const Catalogue& catalogue) {
  if (node.is_string()) return node.string() == "*";
  return node.is_object() && node.has(catalogue.kind) && node[catalogue.kind].string() == "*";
}

/// Of the call's values each number as its shortest text: "5", "5.0" and "5e0" ask for the same.
RawOptions shortest(const MethodCall& call, RawOptions values) {
  using Kind = ParameterSpec::Kind;
  for (const ParameterSpec& spec : call.row->parameters)
    if (const auto value = values.find(spec.name);
        value != values.end() && (spec.kind == Kind::integer || spec.kind == Kind::real))
      value->second = number_text(call.parameters.real(spec.name));
  return values;
}

/// The same for all ways to write a call's numbers; else the call's text.
std::string key_of(const MethodCall& call) {
  std::string key(call.row->name);
  for (const auto& [name, value] : shortest(call, call.parameters.given_options()))
    key += fmt::format("{}{}={}", key.size() == call.row->name.size() ? ':' : ',', name, value);
  return key;
}

bool is_same(const MethodCall& a, const MethodCall& b) {
  return a.row == b.row && shortest(a, a.parameters.all()) == shortest(b, b.parameters.all());
}

/// Each call once; the reference, which has its own cell, not at all: by "*" neither in other
/// words.
void add_calls(const JsonNode& node, const Catalogue& catalogue, Study& study) {
  std::set<std::string> seen{key_of(study.reference)};
  for (const MethodCall& call : study.methods) seen.insert(key_of(call));
  for (const JsonNode& element : node.elements())
    if (catalogue.kind == "method" && is_given(element))
      add_given(element, catalogue, seen, study);
    else
      for (MethodCall& call : read_calls(element, catalogue))
        if (!(is_star(element, catalogue) && is_same(call, study.reference)) &&
            seen.insert(key_of(call)).second)
          study.methods.push_back(std::move(call));
}

/// Cells of two calls whose files have one name would take each other's.
void refuse_shared_files(const JsonNode& node, const Study& study) {
  std::map<std::string, std::string> calls{{study.reference.slug(), study.reference.text()}};
  for (const MethodCall& call : study.methods) {
    const auto [other, is_new] = calls.emplace(call.slug(), call.text());
    if (!is_new)
      node.fail(fmt::format("'{}' and '{}' would share their files, {}; accepted: another name",
                            other->second, call.text(), other->first));
  }
}

/// A scene that is not there, or is something else, is found before hours of work.
fs::path read_scene_path(const JsonNode& node, const fs::path& base) {
  fs::path path = without_dots(base / node.string());
  if (!fs::is_regular_file(path))
    node.fail(fmt::format("'{}' is not a file; accepted: a scene file, relative to the study",
                          path.string()));
  at_place(node, [&] {
    const nlohmann::json scene = read_json(path);
    JsonNode(path.string(), scene)["format"].one_of({"pellucid-scene"});
  });
  return path;
}

std::vector<fs::path> read_scenes(const JsonNode& node, const fs::path& base) {
  std::vector<fs::path> scenes;
  std::set<std::string> names;
  for (const JsonNode& element : node.elements()) {
    scenes.push_back(read_scene_path(element, base));
    if (const std::string name = scene_name(scenes.back()); name == "." || name == "..")
      element.fail(
          fmt::format("a scene named '{}'; accepted: a name that a folder may have", name));
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
  for (const std::string& scene : node.keys()) {
    if (std::find(names.begin(), names.end(), scene) == names.end())
      node.fail(
          unknown_name("scene", scene, std::vector<std::string_view>(names.begin(), names.end())));
    by_scene.emplace(scene, read(node[scene]));
  }
  return by_scene;
}

/// A path, of each scene, or {SCENE: path, …}.
std::map<std::string, fs::path> read_reference_scenes(const JsonNode& node, const Study& study) {
  const auto read = [&](const JsonNode& path) {
    return read_scene_path(path, study.file.parent_path());
  };
  const std::vector<std::string> names = scene_names(study);
  if (node.is_object()) return read_by_scene(node, names, read);
  const fs::path path = read(node);
  std::map<std::string, fs::path> by_scene;
  for (const std::string& name : names) by_scene.emplace(name, path);
  return by_scene;
}

std::vector<std::string> read_measures(const JsonNode& node) {
  std::vector<std::string> names;
  for (const JsonNode& element : node.elements()) {
    const std::string name = element.string();
    at_place(element, [&] { find_row("measure", name, study_measures()); });
    if (std::ranges::find(names, name) != names.end())
      element.fail(fmt::format("a second '{}'; accepted: each once", name));
    names.push_back(name);
  }
  return names;
}

/// A surface that stands behind lines has other elements than they.
MethodCall read_opacities(const JsonNode& node, const Catalogue& methods, const Study& study) {
  if (!study.reference_scenes.empty())
    node.fail("beside a 'reference_scene'; accepted: one of the two");
  MethodCall call = read_call(node, methods);
  return at_place(node, [&] { return checked_opacities(std::move(call)); });
}

/// Takes out the scenes that lack a file that they need. A note says so in the report.
void leave_out(std::vector<LeftOutScene> left_out, Study& study) {
  study.left_out = std::move(left_out);
  for (LeftOutScene& one : study.left_out) {
    const auto scene = std::ranges::find(study.scenes, one.scene, scene_name);
    one.file = *scene;
    study.scenes.erase(scene);
    study.notes.push_back("Of this study " + one.text() + '.');
  }
}

/// A Reading is a study while it is read, with the tables whose rows its calls name.
struct Reading {
  Catalogue methods, integrators;
  Study study = {};

  fs::path folder() const { return study.file.parent_path(); }
  std::vector<std::string> scenes() const { return scene_names(study); }
};

/// A StudyKey is a key of a study file, and what its value sets.
struct StudyKey {
  std::string_view name;
  void (*read)(const JsonNode& value, Reading& to);
  bool required = false;
  std::string_view instead = {};  // the key beside which a required one need not stand
};

/// These keys say that a file is a study. They are checked first: another file would have nothing
/// but unknown keys.
constexpr StudyKey marks[] = {
    {"format", [](const JsonNode& value, Reading&) { value.one_of({"pellucid-study"}); }, true},
    {"version", [](const JsonNode& value, Reading&) { value.integer(1, 1); }, true}};

/// These are all other keys, in the order in which they are read: what names scenes or calls comes
/// after them, and integrators come before methods.
constexpr StudyKey keys[] = {
    {"title", [](const JsonNode& value, Reading& to) { to.study.title = value.string(); }},
    {"source", [](const JsonNode& value, Reading& to) { to.study.source = value.string(); }},
    {"notes",
     [](const JsonNode& value, Reading& to) {
       for (const JsonNode& note : value.elements()) to.study.notes.push_back(note.string());
     }},
    {"scenes",
     [](const JsonNode& value, Reading& to) { to.study.scenes = read_scenes(value, to.folder()); },
     true},
    {"reference_scene",
     [](const JsonNode& value, Reading& to) {
       to.study.reference_scenes = read_reference_scenes(value, to.study);
     }},
    {"reference",
     [](const JsonNode& value, Reading& to) { to.study.reference = read_call(value, to.methods); },
     true},
    {"opacities",
     [](const JsonNode& value, Reading& to) {
       to.study.opacities = read_opacities(value, to.methods, to.study);
     }},
    {"integrators",
     [](const JsonNode& value, Reading& to) { add_calls(value, to.integrators, to.study); }},
    {"methods",
     [](const JsonNode& value, Reading& to) {
       add_calls(value, to.methods, to.study);
       refuse_shared_files(value, to.study);
     },
     true, "integrators"},
    {"repeats",
     [](const JsonNode& value, Reading& to) { to.study.repeats = value.integer(1, max_repeats); }},
    {"timing", [](const JsonNode& value,
                  Reading& to) { to.study.timing = read_timing(value, to.study.repeats); }},
    {"screen",
     [](const JsonNode& value, Reading& to) { to.study.screen = read_screen_rule(value); }},
    {"views", [](const JsonNode& value,
                 Reading& to) { to.study.views = read_views(value, to.study.file.parent_path()); }},
    {"crops", [](const JsonNode& value,
                 Reading& to) { to.study.crops = read_by_scene(value, to.scenes(), read_crop); }},
    {"probes",
     [](const JsonNode& value, Reading& to) {
       to.study.probes = read_by_scene(value, to.scenes(), read_pixels);
     }},
    {"budget",
     [](const JsonNode& value, Reading& to) { to.study.budget = read_budget(value, to.study); }},
    {"measures",
     [](const JsonNode& value, Reading& to) { to.study.measures = read_measures(value); }},
    {"claims",
     [](const JsonNode& value, Reading& to) {
       for (const JsonNode& element : value.elements())
         to.study.claims.push_back(read_claim(element, to.study));
     }},
    {"ladders",
     [](const JsonNode& value, Reading& to) {
       for (const JsonNode& element : value.elements())
         to.study.ladders.push_back(read_ladder(element, to.study));
     }},
    {"growth",
     [](const JsonNode& value, Reading& to) {
       for (const JsonNode& element : value.elements())
         to.study.growth.push_back(read_growth(element, to.study));
     }},
    {"published", [](const JsonNode& value,
                     Reading& to) { to.study.published = read_published(value, to.study); }},
    // The last: what other keys say of a scene holds whether or not its data are there.
    {"needs", [](const JsonNode& value, Reading& to) {
       leave_out(read_needs(value, to.folder(), to.scenes()), to.study);
     }}};

void read_keys(std::span<const StudyKey> table, const JsonNode& root, Reading& to) {
  for (const StudyKey& key : table)
    if (root.has(key.name) || (key.required && !root.has(key.instead)))
      key.read(root[key.name], to);
}

void refuse_other_keys(const JsonNode& root) {
  std::vector<std::string_view> known;
  for (const StudyKey& key : marks) known.push_back(key.name);
  for (const StudyKey& key : keys) known.push_back(key.name);
  root.accept_keys(known);
}

}  // namespace

std::string scene_name(const fs::path& scene) { return scene.stem().string(); }

std::vector<std::string> scene_names(const Study& study) {
  std::vector<std::string> names;
  names.reserve(study.scenes.size());
  for (const fs::path& scene : study.scenes) names.push_back(scene_name(scene));
  return names;
}

TimingRule timing_of(const Study& study) {
  return study.timing.value_or(fixed_repeats(study.repeats));
}

Study load_study(const fs::path& file, std::span<const scene::MethodRow> methods,
                 std::span<const scene::MethodRow> integrators) {
  const nlohmann::json json = read_json(file);
  const JsonNode root(file.string(), json);
  Reading reading{{"method", methods, file.parent_path()}, {"integrator", integrators}};
  reading.study.file = file;
  reading.study.name = reading.study.title = file.stem().string();
  read_keys(marks, root, reading);
  refuse_other_keys(root);
  read_keys(keys, root, reading);
  check_scenes(root, reading.study);
  return std::move(reading.study);
}

}  // namespace pellucid::compare
