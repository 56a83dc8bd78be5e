// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/appearance/colormap.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.h"
#include "core/options/names.h"

namespace pellucid::scene {
namespace {

#include "scene/appearance/colormap_tables.inc"

/// The four colours of Li, Chen, Multi-Resolution Isosurface Rendering (2023), Sect. 3.3, in
/// tenths, for a range in three equal parts. Erratum: the listing there parts it at (max + min) / 3
/// and twice that, which is right where min is 0 alone, and leaves colours outside of [0, 1]
/// elsewhere; the text speaks of four parts, which four colours cannot bound.
constexpr std::uint8_t four_color_table[4][3] = {{0, 9, 2}, {8, 8, 0}, {10, 0, 0}, {4, 6, 0}};

constexpr std::array<ColormapRow, 8> rows{{
    {"viridis", "Smith, van der Walt 2015", viridis_table},
    {"magma", "Smith, van der Walt 2015", magma_table},
    {"inferno", "Smith, van der Walt 2015", inferno_table},
    {"plasma", "Smith, van der Walt 2015", plasma_table},
    {"cividis", "Nuñez, Anderton, Renslow 2018", cividis_table},
    {"turbo", "Mikhailov 2019", turbo_table},
    {"coolwarm", "Moreland 2009", coolwarm_table},
    {"four-color", "Li, Chen 2023, Sect. 3.3", four_color_table, 4, 10},
}};

Vec3 entry(const ColormapRow& map, int i) {
  return Vec3(map.table[i][0], map.table[i][1], map.table[i][2]) / map.unit;
}

}  // namespace

double fraction_between(double value, double low, double high) {
  if (std::isfinite(high - low)) return (value - low) / (high - low);
  return (value / 2 - low / 2) / (high / 2 - low / 2);  // halves of large numbers are exact
}

Vec3 ColormapRow::operator()(double x) const {
  if (std::isnan(x)) return nan_color;
  const double position = std::clamp(x, 0.0, 1.0) * (count - 1);
  const int below = std::min(static_cast<int>(position), count - 2);
  const double fraction = position - below;
  return entry(*this, below) * (1 - fraction) + entry(*this, below + 1) * fraction;
}

Colormap::Colormap(std::vector<ColorStop> stops) : stops_(std::move(stops)) {
  if (stops_.size() < 2) throw InputError("a colour map has two stops or more");
  for (std::size_t i = 1; i < stops_.size(); ++i)
    if (!(stops_[i].at > stops_[i - 1].at))
      throw InputError(
          fmt::format("stop {} of the colour map is at {} after {}; they have to ascend", i,
                      stops_[i].at, stops_[i - 1].at));
}

Vec3 Colormap::operator()(double x) const {
  if (std::isnan(x)) return nan_color;
  const double at = std::lerp(ends().x, ends().y, std::clamp(x, 0.0, 1.0));
  const auto after = std::upper_bound(stops_.begin() + 1, stops_.end() - 1, at,
                                      [](double a, const ColorStop& stop) { return a < stop.at; });
  const ColorStop &below = *(after - 1), &above = *after;
  return glm::mix(below.color, above.color, fraction_between(at, below.at, above.at));
}

std::span<const ColormapRow> colormaps() { return rows; }

const ColormapRow& find_colormap(std::string_view name) {
  return find_row("colour map", name, rows);
}

}  // namespace pellucid::scene
