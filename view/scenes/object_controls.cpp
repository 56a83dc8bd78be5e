// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/scenes/object_controls.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "core/options/option_table.h"
#include "core/options/parameters_json.h"
#include "fields/levels/level_field.h"
#include "scene/appearance/appearance.h"
#include "scene/appearance/color_text.h"
#include "scene/appearance/colormap.h"

namespace pellucid::view {
namespace {

using nlohmann::json;
using Kind = ParameterSpec::Kind;

constexpr double tiny = std::numeric_limits<double>::min();

/// A ControlRow is a row of the table of controls.
struct ControlRow {
  ParameterSpec spec;
  /// Where the value stands in the object's text.
  json::json_pointer place;
  /// Whether an object has the control.
  bool (*applies)(const json& object);
};

bool has_own_opacity(const json& object) {
  if (const auto opacity = object.find("opacity"); opacity != object.end())
    return opacity->is_number();
  const auto color = object.find("color");
  return color == object.end() || !color->is_string() ||
         !scene::color_of_text(color->get<std::string>()).alpha;
}

bool has_named_map(const json& object) {
  const auto color = object.find("color");
  return color != object.end() && color->is_object() &&
         (!color->contains("map") || color->at("map").is_string());
}

const std::string& names_of_maps() {
  static const std::string names = [] {
    std::string joined;
    for (const scene::ColormapRow& map : scene::colormaps())
      option_detail::add_choice(joined, map.name);
    return joined;
  }();
  return names;
}

const std::vector<ControlRow>& rows() {
  static const std::vector<ControlRow> table{
      {{.name = "opacity", .kind = Kind::real, .min = 0, .max = 1, .help = "of every layer"},
       json::json_pointer("/opacity"),
       has_own_opacity},
      {{.name = "map",
        .kind = Kind::choice,
        .default_value = "viridis",
        .choices = names_of_maps(),
        .help = "colour map"},
       json::json_pointer("/color/map"),
       has_named_map},
      {{.name = "isovalue",
        .kind = Kind::real,
        .help = "value of the surface, in the scalar's unit"},
       json::json_pointer("/isosurface/value"),
       [](const json& object) { return object.contains("isosurface"); }},
      {{.name = "radius",
        .kind = Kind::real,
        .min = tiny,
        .unit = "world units",
        .help = "half width"},
       json::json_pointer("/radius"),
       [](const json& object) {
         return object.contains("radius") && object["radius"].is_number();
       }},
      {{.name = "radius-scale",
        .kind = Kind::real,
        .default_value = "1",
        .min = tiny,
        .help = "of the scalar that gives the radius"},
       json::json_pointer("/radius/scale"),
       [](const json& object) {
         return object.contains("radius") && object["radius"].is_object();
       }},
      {{.name = "halo-width",
        .kind = Kind::real,
        .min = 0,
        .unit = "world units",
        .help = "beyond the line's rim"},
       json::json_pointer("/halo/width"),
       [](const json& object) { return object.contains("halo"); }},
      {{.name = "halo-depth",
        .kind = Kind::real,
        .min = 0,
        .unit = "world units",
        .help = "by which its outer rim lies behind the line"},
       json::json_pointer("/halo/depth"),
       [](const json& object) { return object.contains("halo"); }}};
  return table;
}

std::string text_of(const json& value) {
  return value.is_number() ? number_text(value.get<double>()) : value.get<std::string>();
}

/// Least and largest sample of an isosurface that is crossed as such; of an extracted one nothing
/// is known.
Vec2 samples_range(const scene::SceneObject& made) {
  Vec2 range(-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity());
  const auto* surface = std::get_if<scene::Isosurface>(&made.shape);
  if (!surface) return range;
  range = {range.y, range.x};
  for (const fields::ScalarLevel& level : surface->field->levels())
    for (const float kept : level.samples) {
      const double sample = surface->field->scale().value(kept);
      range = {std::min(range.x, sample), std::max(range.y, sample)};
    }
  return range;
}

/// Controls are an object's rows; the defaults' texts are its own.
struct Controls {
  std::vector<ParameterSpec> specs;
  std::vector<json::json_pointer> places;
  std::vector<std::string> defaults;

  Controls(const json& object, const scene::SceneObject& made) {
    defaults.reserve(rows().size());  // specs point into it
    for (const ControlRow& row : rows())
      if (row.applies(object)) add(row, object, made);
  }

  void add(const ControlRow& row, const json& object, const scene::SceneObject& made) {
    ParameterSpec spec = row.spec;
    if (object.contains(row.place)) {
      defaults.push_back(text_of(object.at(row.place)));
      spec.default_value = defaults.back();
    }
    if (spec.name == "isovalue") {
      const Vec2 range = samples_range(made);
      const double value = object.at(row.place).get<double>();
      spec.min = std::min(range.x, value);
      spec.max = std::max(range.y, value);
    }
    specs.push_back(spec);
    places.push_back(row.place);
  }
};

}  // namespace

nlohmann::ordered_json control_rows(const json& object, const scene::SceneObject& made) {
  return parameters_json(Controls(object, made).specs);
}

json with_settings(json object, const scene::SceneObject& made, const RawOptions& settings) {
  const Controls controls(object, made);
  const Parameters values(made.name, controls.specs, settings);
  for (std::size_t i = 0; i < controls.specs.size(); ++i) {
    const std::string_view name = controls.specs[i].name;
    if (!settings.contains(name)) continue;
    json& value = object[controls.places[i]];
    if (controls.specs[i].kind == Kind::real)
      value = values.real(name);
    else
      value = values.text(name);
  }
  return object;
}

}  // namespace pellucid::view
