// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/files/appearance_file.h"

#include <fmt/format.h>

#include <charconv>
#include <string_view>

#include "scene/appearance/color_text.h"
#include "scene/files/any_number.h"
#include "scene/files/colormap_file.h"

namespace pellucid::scene {
namespace {

Vec2 read_opacities(const JsonNode& node) {
  const auto ends = node.elements();
  if (ends.size() != 2) node.fail("accepted: two numbers");
  return {ends[0].number(0, 1), ends[1].number(0, 1)};
}

/// Of "98%", 98.
double read_percentile(const JsonNode& node) {
  const std::string text = node.string();
  double percentile = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), percentile);
  if (error != std::errc() || std::string_view(end) != "%" ||
      !(percentile >= 0 && percentile <= 100))
    node.fail(fmt::format("'{}'; accepted: a number, or a percentile, \"0%\" … \"100%\"", text));
  return percentile;
}

/// The keys range and scale of a ScalarColor or a ScalarOpacity.
template <class By>
void read_range(const JsonNode& node, By& by) {
  if (node.has("scale") && node["scale"].one_of({"linear", "logarithmic"}) == "logarithmic")
    by.scale = Scale::logarithmic;
  if (!node.has("range")) return;
  const auto ends = node["range"].elements();
  if (ends.size() != 2)
    node["range"].fail("accepted: two numbers or percentiles, such as [0, 1], [\"2%\", \"98%\"]");
  by.range.emplace();
  for (const std::size_t k : {0, 1}) {
    by.in_percent[k] = ends[k].is_string();
    (*by.range)[int(k)] = by.in_percent[k] ? read_percentile(ends[k]) : ends[k].number(-any, any);
    if (by.scale == Scale::logarithmic && !by.in_percent[k] && !((*by.range)[int(k)] > 0))
      ends[k].fail("accepted on a logarithmic scale: a number above 0");
  }
}

TextColor read_text_color(const JsonNode& node) {
  return at_place(node, [&] { return color_of_text(node.string()); });
}

std::variant<std::monostate, Vec3, ScalarColor> read_color(const JsonNode& node,
                                                           const std::filesystem::path& folder) {
  if (node.is_string()) return read_text_color(node).rgb;
  if (!node.is_object()) return read_rgb(node);
  node.accept_keys({"by", "map", "range", "scale", "nan_color"});
  ScalarColor color;
  color.scalar = node["by"].string();
  read_range(node, color);
  if (node.has("nan_color")) color.nan = read_rgb(node["nan_color"]);
  const Scale own = color.scale;
  if (node.has("map")) read_colormap(node["map"], folder, color);
  if (node.has("scale") && color.scale != own)
    node["scale"].fail("its map is by UseLogScale; accepted: logarithmic");
  return color;
}

std::variant<std::monostate, double, ScalarOpacity> read_opacity(const JsonNode& node) {
  if (!node.is_object()) return node.number(0, 1);
  node.accept_keys({"by", "opacities", "range", "scale"});
  ScalarOpacity opacity;
  opacity.scalar = node["by"].string();
  opacity.opacities = read_opacities(node["opacities"]);
  read_range(node, opacity);
  return opacity;
}

std::variant<std::monostate, double, std::string> read_importance(const JsonNode& node) {
  if (node.is_string()) return node.string();
  return node.number(0, 1);
}

/// A colour's own opacity is the object's.
void take_opacity_of_color(const JsonNode& node, Appearance& appearance) {
  if (!node["color"].is_string()) return;
  const auto alpha = read_text_color(node["color"]).alpha;
  if (!alpha) return;
  if (node.has("opacity")) node["color"].fail("has an opacity, too; accepted: one of both");
  appearance.opacity = *alpha;
}

}  // namespace

Vec3 read_rgb(const JsonNode& node) {
  if (node.is_string()) return at_place(node, [&] { return rgb_of_text(node.string()); });
  const Vec3 rgb = node.vec3();
  for (const JsonNode& channel : node.elements()) channel.number(0, 1);
  return rgb;
}

Lighting read_lighting(const JsonNode& node) {
  return Lighting(std::ranges::find(lighting_names, node.one_of(lighting_names)) -
                  lighting_names.begin());
}

Appearance read_appearance(const JsonNode& node, const std::filesystem::path& folder) {
  Appearance appearance;
  if (node.has("color")) {
    appearance.color = read_color(node["color"], folder);
    take_opacity_of_color(node, appearance);
  }
  if (node.has("opacity")) appearance.opacity = read_opacity(node["opacity"]);
  if (node.has("importance")) appearance.importance = read_importance(node["importance"]);
  return appearance;
}

}  // namespace pellucid::scene
