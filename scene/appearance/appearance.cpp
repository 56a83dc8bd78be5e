// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/appearance/appearance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/options/names.h"
#include "geometry/vertex_normals.h"
#include "scene/appearance/colormap.h"

namespace pellucid::scene {
namespace {

const Vec3 default_color(0.8);

const std::vector<double>& find_scalar(const geometry::Vertices& vertices,
                                       const std::string& name) {
  const auto found = vertices.scalars.find(name);
  if (found != vertices.scalars.end()) return found->second;
  std::vector<std::string_view> known;
  for (const auto& [scalar, values] : vertices.scalars) known.push_back(scalar);
  throw InputError(unknown_name("scalar", name, known));
}

void set_rgb(Rgba& color, const Vec3& rgb) { color = Rgba(Vec3(rgb), color.a); }

void color_by_scalar(const ScalarColor& by, geometry::Vertices& vertices) {
  const std::vector<double>& values = find_scalar(vertices, by.scalar);
  const ColormapRow& map = find_colormap(by.map);
  const Vec2 range = by.range.value_or(finite_range(values));
  for (std::size_t i = 0; i < values.size(); ++i)
    set_rgb(vertices.colors[i], map(fraction_of(values[i], range)));
}

/// The fraction of the range within [0, 1]; 0 for NaN, which fmax passes over.
double share_of(double value, const Vec2& range) {
  return std::fmin(std::fmax(fraction_of(value, range), 0.0), 1.0);
}

void fade_by_scalar(const ScalarOpacity& by, geometry::Vertices& vertices) {
  const std::vector<double>& values = find_scalar(vertices, by.scalar);
  const Vec2 range = by.range.value_or(finite_range(values));
  for (std::size_t i = 0; i < values.size(); ++i) {
    vertices.colors[i].a =
        float(std::lerp(by.opacities.x, by.opacities.y, share_of(values[i], range)));
  }
}

void weigh_by_scalar(const std::string& scalar, geometry::Vertices& vertices) {
  const std::vector<double>& values = find_scalar(vertices, scalar);
  const Vec2 range = finite_range(values);
  vertices.importance.resize(values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    vertices.importance[i] = static_cast<float>(share_of(values[i], range));
}

}  // namespace

double fraction_of(double value, const Vec2& range) {
  if (std::isnan(value)) return value;
  return range.x != range.y ? (value - range.x) / (range.y - range.x) : 0;
}

Vec2 finite_range(const std::vector<double>& values) {
  Vec2 range(std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity());
  for (const double value : values)
    if (std::isfinite(value)) range = {std::min(range.x, value), std::max(range.y, value)};
  return range;
}

void apply_appearance(const Appearance& appearance, geometry::Vertices& vertices) {
  if (vertices.colors.empty())
    vertices.colors.assign(vertices.positions.size(), Rgba(default_color, 1));
  if (const auto* rgb = std::get_if<Vec3>(&appearance.color))
    for (Rgba& color : vertices.colors) set_rgb(color, *rgb);
  if (const auto* by = std::get_if<ScalarColor>(&appearance.color)) color_by_scalar(*by, vertices);
  if (const auto* opacity = std::get_if<double>(&appearance.opacity))
    for (Rgba& color : vertices.colors) color.a = static_cast<float>(*opacity);
  if (const auto* by = std::get_if<ScalarOpacity>(&appearance.opacity))
    fade_by_scalar(*by, vertices);
  if (const auto* g = std::get_if<double>(&appearance.importance))
    vertices.importance.assign(vertices.positions.size(), static_cast<float>(*g));
  if (const auto* by = std::get_if<std::string>(&appearance.importance))
    weigh_by_scalar(*by, vertices);
}

void ensure_normals(geometry::TriangleMesh& mesh) {
  if (mesh.normals.empty()) mesh.normals = geometry::facet_normals(mesh);
}

}  // namespace pellucid::scene
