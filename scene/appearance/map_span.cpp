// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/appearance/map_span.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pellucid::scene {
namespace {

/// The places in the map of all vertices; NaN where there is no colour of it.
std::vector<float> places_of(const ScalarColor& by, const geometry::Vertices& vertices) {
  const std::vector<double>& values = vertices.scalars.at(by.scalar);
  const Vec2 range = range_over(by, values);
  std::vector<float> places;
  places.reserve(values.size());
  for (const double value : values) {
    const double x = fraction_of(value, range, by.scale);
    places.push_back(float(std::isnan(x) ? x : std::clamp(x, 0.0, 1.0)));
  }
  return places;
}

/// 0 where one of both is NaN.
float between(float a, float b) {
  const float span = std::abs(a - b);
  return span > 0 ? span : 0;
}

constexpr std::string_view remark_end = "of the colour map, which it has at its ends alone";

}  // namespace

double map_span(const ScalarColor& by, const geometry::TriangleMesh& mesh) {
  const std::vector<float> at = places_of(by, mesh);
  float largest = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    largest =
        std::max({largest, between(at[a], at[b]), between(at[b], at[c]), between(at[c], at[a])});
  return largest;
}

double map_span(const ScalarColor& by, const geometry::LineSet& lines) {
  const std::vector<float> at = places_of(by, lines);
  float largest = 0;
  for (std::size_t k = 0; k < lines.line_count(); ++k)
    for (std::uint64_t i = lines.offsets[k]; i + 1 < lines.offsets[k + 1]; ++i)
      largest = std::max(largest, between(at[i], at[i + 1]));
  return largest;
}

void remark_map_span(double span, std::string_view what, geometry::Vertices& vertices) {
  constexpr double much = 0.1;
  std::erase_if(vertices.remarks,
                [](const std::string& remark) { return remark.ends_with(remark_end); });
  if (span > much)
    vertices.remarks.push_back(fmt::format("a {} passes over {:.2g} {}", what, span, remark_end));
}

}  // namespace pellucid::scene
