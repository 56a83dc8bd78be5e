// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/files/object_look.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/appearance/face_scalars.h"
#include "scene/appearance/map_span.h"
#include "scene/files/appearance_file.h"

namespace pellucid::scene {
namespace {

/// Colours are the map's at vertices alone.
void remark_span(const ScalarColor& by, SceneObject& object) {
  if (auto* mesh = std::get_if<geometry::TriangleMesh>(&object.shape))
    remark_map_span(map_span(by, *mesh), "triangle", *mesh);
  if (auto* lines = std::get_if<LineObject>(&object.shape))
    remark_map_span(map_span(by, lines->set), "segment", lines->set);
}

/// Where no value of a scalar is a number, nothing is by it.
void remark_lack(const std::string& scalar, std::string_view what, geometry::Vertices& vertices) {
  const auto found = vertices.scalars.find(scalar);
  if (found == vertices.scalars.end() ||
      std::ranges::any_of(found->second, [](double value) { return std::isfinite(value); }))
    return;
  vertices.remarks.push_back(
      fmt::format("no value of '{}' is a number: its {} is that of none", scalar, what));
}

template <class By>
bool is_in_percent(const By* by) {
  return by && by->range && !has_given_range(*by);
}

/// Of the values as the file has them, before vertices of faces are made to have them.
template <class By>
void find_percentiles(By* by, const FileValues& values, const geometry::Vertices& vertices) {
  if (!is_in_percent(by)) return;
  const auto of_file = values.find(by->scalar);
  const auto of_vertex = vertices.scalars.find(by->scalar);
  if (of_file == values.end() && of_vertex == vertices.scalars.end()) return;
  by->range = range_over(*by, of_file == values.end() ? of_vertex->second : of_file->second);
  by->in_percent = {};
}

/// The range of the whole surface, for lines on it.
template <class By>
void fill_in_range(By* by, const geometry::Vertices& vertices) {
  if (!by) return;
  by->range = range_over(*by, vertices.scalars.at(by->scalar));
  by->in_percent = {};
}

}  // namespace

void apply_look(const JsonNode& node, const std::filesystem::path& folder, const FileValues& values,
                SceneObject& object) {
  Appearance appearance = read_appearance(node, folder);
  if (node.has("isosurface")) {  // what is by a scalar, it has: none is at its vertices
    if (std::holds_alternative<ScalarColor>(appearance.color)) appearance.color = {};
    if (std::holds_alternative<ScalarOpacity>(appearance.opacity)) appearance.opacity = {};
  }
  auto* color = std::get_if<ScalarColor>(&appearance.color);
  auto* opacity = std::get_if<ScalarOpacity>(&appearance.opacity);
  at_place(node, [&] {
    find_percentiles(color, values, object.vertices());
    find_percentiles(opacity, values, object.vertices());
    if (auto* mesh = std::get_if<geometry::TriangleMesh>(&object.shape)) {
      bring_to_vertices(appearance, *mesh);
      mesh->face_scalars.clear();  // nobody asks for them any more
    }
    apply_appearance(appearance, object.vertices());
  });
  if (color) remark_span(*color, object);
  if (color) remark_lack(color->scalar, "colour", object.vertices());
  if (opacity) remark_lack(opacity->scalar, "opacity", object.vertices());
  if (!object.source) return;
  fill_in_range(color, object.vertices());
  fill_in_range(opacity, object.vertices());
  object.source->appearance = appearance;
}

bool asks_percentiles_of_file(const JsonNode& node, const std::filesystem::path& folder) {
  if (!node.has("mesh") && !(node.has("lines") && !node["lines"].is_object())) return false;
  const Appearance appearance = read_appearance(node, folder);
  return is_in_percent(std::get_if<ScalarColor>(&appearance.color)) ||
         is_in_percent(std::get_if<ScalarOpacity>(&appearance.opacity));
}

}  // namespace pellucid::scene
