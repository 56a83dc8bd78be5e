// SPDX-License-Identifier: GPL-3.0-or-later
// Colour maps of a scene file. ParaView's preset is a list of maps, of which the first counts:
//   [{"ColorSpace": "RGB", "Name": "…", "RGBPoints": [x, r, g, b, x, r, g, b, …], "NanColor": …,
//     "UseLogScale": 0}]

#include "scene/files/colormap_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "core/options/names.h"
#include "scene/appearance/color_space.h"
#include "scene/appearance/colormap.h"
#include "scene/files/any_number.h"
#include "scene/files/appearance_file.h"

namespace pellucid::scene {
namespace {

/// Stops as they stand, [place, colour] each; or colours alone, at even distances.
std::vector<ColorStop> read_stops(const JsonNode& node) {
  const auto entries = node.elements();
  std::vector<ColorStop> stops;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (entries[i].is_array() && entries[i].value().size() == 2) {
      const auto stop = entries[i].elements();
      stops.push_back({stop[0].number(-any, any), read_rgb(stop[1])});
    } else {
      const double last = std::max(double(entries.size()) - 1, 1.0);
      stops.push_back({double(i) / last, read_rgb(entries[i])});
    }
  }
  return stops;
}

/// RGBPoints: four numbers a stop.
std::vector<ColorStop> read_points(const JsonNode& node) {
  const auto numbers = node.elements();
  if (numbers.size() % 4 != 0) node.fail("accepted: four numbers a stop: value, red, green, blue");
  std::vector<ColorStop> stops;
  for (std::size_t i = 0; i < numbers.size(); i += 4)
    stops.push_back(
        {numbers[i].number(-any, any),
         {numbers[i + 1].number(0, 1), numbers[i + 2].number(0, 1), numbers[i + 3].number(0, 1)}});
  return stops;
}

const ColorSpace& color_space_of(const JsonNode& map) {
  if (!map.has("ColorSpace")) return color_spaces().front();
  const JsonNode name = map["ColorSpace"];
  return at_place(name, [&]() -> const ColorSpace& {
    return find_row("colour space", name.string(), color_spaces());
  });
}

bool is_logarithmic(const JsonNode& map) {
  if (!map.has("UseLogScale")) return false;
  const JsonNode use = map["UseLogScale"];
  return use.value().is_boolean() ? use.boolean() : use.number(0, 1) != 0;
}

bool are_fractions(const std::vector<ColorStop>& stops) {
  return !stops.empty() && stops.front().at == 0 && stops.back().at == 1;
}

bool ascend_above_zero(const std::vector<ColorStop>& stops) {
  return stops.front().at > 0 && std::ranges::is_sorted(stops, std::less_equal<>(), &ColorStop::at);
}

/// On a logarithmic scale: places stops that are values by their logarithms, from 0 to 1, and makes
/// the values of the outermost the range.
std::vector<ColorStop> placed(std::vector<ColorStop> stops, const JsonNode& where,
                              ScalarColor& color) {
  if (color.scale == Scale::linear || stops.empty() || are_fractions(stops)) return stops;
  const Vec2 ends(stops.front().at, stops.back().at);
  if (!ascend_above_zero(stops))
    where.fail(
        fmt::format("values from {} to {}; accepted on a logarithmic scale: ascending values "
                    "above 0, or fractions from 0 to 1",
                    ends.x, ends.y));
  for (ColorStop& stop : stops) stop.at = std::log(stop.at / ends.x) / std::log(ends.y / ends.x);
  stops.back().at = 1;
  if (!color.range) color.range = ends;
  return stops;
}

std::vector<ColorStop> read_paraview(const JsonNode& root, ScalarColor& color) {
  const auto maps = root.is_array() ? root.elements() : std::vector{root};
  if (maps.empty()) root.fail("no colour map; accepted: one that ParaView has exported");
  const JsonNode& map = maps.front();
  if (!map.has("RGBPoints")) map.fail("accepted: ParaView's RGBPoints");
  if (map.has("NanColor") && !color.nan) color.nan = read_rgb(map["NanColor"]);
  const JsonNode points = map["RGBPoints"];
  if (is_logarithmic(map)) color.scale = Scale::logarithmic;
  return linear_in_rgb(placed(read_points(points), points, color), color_space_of(map));
}

bool is_paraview(const JsonNode& node) {
  return node.is_object() ||
         (node.is_array() && !node.value().empty() && node.value()[0].is_object());
}

void take(std::vector<ColorStop> stops, ScalarColor& color) {
  color.custom = std::make_shared<const Colormap>(std::move(stops));
  const Vec2 ends = color.custom->ends();
  if (!color.range && ends != Vec2(0, 1)) color.range = ends;
}

}  // namespace

void read_colormap(const JsonNode& node, const std::filesystem::path& folder, ScalarColor& color) {
  if (is_paraview(node)) return at_place(node, [&] { take(read_paraview(node, color), color); });
  if (node.is_array())
    return at_place(node, [&] { take(placed(read_stops(node), node, color), color); });
  color.map = node.string();
  if (!color.map.ends_with(".json")) return;
  const std::filesystem::path path = folder / color.map;
  at_place(node, [&] {
    const nlohmann::json json = read_json(path);
    take(read_paraview(JsonNode(path.string(), json), color), color);
  });
}

}  // namespace pellucid::scene
