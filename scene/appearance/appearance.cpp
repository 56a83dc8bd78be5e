// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/appearance/appearance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/options/names.h"
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

void fade_by_scalar(const ScalarOpacity& by, geometry::Vertices& vertices) {
  const std::vector<double>& values = find_scalar(vertices, by.scalar);
  const Vec2 range = by.range.value_or(finite_range(values));
  for (std::size_t i = 0; i < values.size(); ++i) {
    // fmax takes NaN for 0.
    const double share = std::fmin(std::fmax(fraction_of(values[i], range), 0.0), 1.0);
    vertices.colors[i].a = float(std::lerp(by.opacities.x, by.opacities.y, share));
  }
}

}  // namespace

double fraction_of(double value, const Vec2& range) {
  return range.y > range.x ? (value - range.x) / (range.y - range.x) : 0;
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
  if (appearance.importance) {
    const std::vector<double>& values = find_scalar(vertices, *appearance.importance);
    const Vec2 range = finite_range(values);
    vertices.importance.resize(values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
      vertices.importance[i] =
          static_cast<float>(std::clamp(fraction_of(values[i], range), 0.0, 1.0));
  }
}

void ensure_normals(geometry::TriangleMesh& mesh) {
  if (!mesh.normals.empty()) return;
  mesh.normals.assign(mesh.positions.size(), Vec3(0));
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 area =
        glm::cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
    for (const std::uint32_t v : {a, b, c}) mesh.normals[v] += area;
  }
  for (Vec3& n : mesh.normals) {
    const double length = glm::length(n);
    n = length > 0 ? n / length : Vec3(0, 0, 1);
  }
}

}  // namespace pellucid::scene
