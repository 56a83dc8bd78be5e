// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/appearance/appearance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "core/error.h"
#include "core/options/names.h"
#include "geometry/default_color.h"
#include "geometry/vertex_normals.h"
#include "scene/appearance/colormap.h"

namespace pellucid::scene {

const std::vector<double>& find_scalar(const geometry::Vertices& vertices,
                                       const std::string& name) {
  const auto found = vertices.scalars.find(name);
  if (found != vertices.scalars.end()) return found->second;
  std::vector<std::string_view> known;
  for (const auto& [scalar, values] : vertices.scalars) known.push_back(scalar);
  throw InputError(unknown_name("scalar", name, known));
}

namespace {

void set_rgb(Rgba& color, const Vec3& rgb) { color = Rgba(Vec3(rgb), color.a); }

void color_by_scalar(const ScalarColor& by, geometry::Vertices& vertices) {
  const std::vector<double>& values = find_scalar(vertices, by.scalar);
  const ColormapRow* row = by.custom ? nullptr : &find_colormap(by.map);
  const Vec2 range = range_over(by, values);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double x = fraction_of(values[i], range, by.scale);
    const Vec3 color = row ? (*row)(x) : (*by.custom)(x);
    set_rgb(vertices.colors[i], std::isnan(x) ? by.nan.value_or(nan_color) : color);
  }
}

/// The fraction of the range within [0, 1]; 0 for NaN, which fmax passes over.
double share_of(double value, const Vec2& range, Scale scale = Scale::linear) {
  return std::fmin(std::fmax(fraction_of(value, range, scale), 0.0), 1.0);
}

void fade_by_scalar(const ScalarOpacity& by, geometry::Vertices& vertices) {
  const std::vector<double>& values = find_scalar(vertices, by.scalar);
  const Vec2 range = range_over(by, values);
  for (std::size_t i = 0; i < values.size(); ++i) {
    vertices.colors[i].a =
        float(std::lerp(by.opacities.x, by.opacities.y, share_of(values[i], range, by.scale)));
  }
}

std::vector<double> positive_of(const std::vector<double>& values) {
  std::vector<double> some;
  std::ranges::copy_if(values, std::back_inserter(some), [](double value) { return value > 0; });
  return some;
}

template <class By>
Vec2 found_range(const By& by, const std::vector<double>& values) {
  if (!by.range) return finite_range(values);
  Vec2 range = *by.range;
  for (const int end : {0, 1})
    if (by.in_percent[std::size_t(end)]) range[end] = percentile_of(values, range[end]);
  return range;
}

/// Values that have no place on the scale are left out of what is asked of all.
template <class By>
Vec2 range_on_scale(const By& by, const std::vector<double>& values) {
  if (by.scale == Scale::linear) return found_range(by, values);
  const std::vector<double> positive = positive_of(values);
  const Vec2 range = found_range(by, positive);
  if (!has_given_range(by) && finite_range(positive).x > finite_range(positive).y)
    throw InputError(fmt::format(
        "'{}' has no value above 0; accepted on a logarithmic scale: values above 0", by.scalar));
  if (!(range.x > 0 && range.y > 0))
    throw InputError(
        fmt::format("the range of '{}' is {} … {}; accepted on a logarithmic scale: ends above 0",
                    by.scalar, range.x, range.y));
  return range;
}

void weigh_by_scalar(const std::string& scalar, geometry::Vertices& vertices) {
  const std::vector<double>& values = find_scalar(vertices, scalar);
  const Vec2 range = finite_range(values);
  vertices.importance.resize(values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    vertices.importance[i] = static_cast<float>(share_of(values[i], range));
}

}  // namespace

namespace {

/// The limit of a range that shrinks to one value: before it, at its low end, or beyond it.
double fraction_off(double value, double only) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (value == only) return 0;
  return value < only ? -infinity : infinity;
}

}  // namespace

double fraction_of(double value, const Vec2& range, Scale scale) {
  if (std::isnan(value)) return value;
  if (range.x == range.y) return fraction_off(value, range.x);
  if (scale == Scale::linear) return fraction_between(value, range.x, range.y);
  const double low = std::log(range.x), high = std::log(range.y);
  return (std::log(std::max(value, 0.0)) - low) / (high - low);
}

Vec2 finite_range(const std::vector<double>& values) {
  Vec2 range(std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity());
  for (const double value : values)
    if (std::isfinite(value)) range = {std::min(range.x, value), std::max(range.y, value)};
  return range;
}

double percentile_of(std::vector<double> values, double percentile) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const double place = percentile / 100 * double(values.size() - 1);
  const auto below = values.begin() + std::ptrdiff_t(place);
  std::nth_element(values.begin(), below, values.end());
  if (below + 1 == values.end()) return *below;
  return std::lerp(*below, *std::min_element(below + 1, values.end()), place - std::floor(place));
}

Vec2 range_over(const ScalarColor& by, const std::vector<double>& values) {
  return range_on_scale(by, values);
}
Vec2 range_over(const ScalarOpacity& by, const std::vector<double>& values) {
  return range_on_scale(by, values);
}

std::vector<std::string> scalars_of(const Appearance& appearance) {
  std::vector<std::string> names;
  if (const auto* by = std::get_if<ScalarColor>(&appearance.color)) names.push_back(by->scalar);
  if (const auto* by = std::get_if<ScalarOpacity>(&appearance.opacity)) names.push_back(by->scalar);
  if (const auto* by = std::get_if<std::string>(&appearance.importance)) names.push_back(*by);
  return names;
}

void apply_appearance(const Appearance& appearance, geometry::Vertices& vertices) {
  if (vertices.colors.empty())
    vertices.colors.assign(vertices.positions.size(), Rgba(geometry::default_color, 1));
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
