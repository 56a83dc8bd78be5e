// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/files/radius_file.h"

#include <fmt/format.h>

#include "scene/appearance/appearance.h"
#include "scene/files/any_number.h"

namespace pellucid::scene {
namespace {

double positive(const JsonNode& node, std::string_view accepted) {
  const double number = node.number(0, any);
  if (number == 0) node.fail(fmt::format("0; accepted: {}", accepted));
  return number;
}

JsonNode by_of(const JsonNode& radius) {
  radius.accept_keys({"by", "scale"});
  return radius["by"];
}

Radii radii_by_scalar(const JsonNode& node, const geometry::Vertices& vertices) {
  const JsonNode by = by_of(node);
  const std::string scalar = by.string();
  const double scale = node.has("scale") ? positive(node["scale"], "a number above 0") : 1;
  std::vector<double> radii = at_place(by, [&] { return find_scalar(vertices, scalar); });
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const double value = radii[i];
    radii[i] *= scale;
    if (!(radii[i] >= 0 && radii[i] < geometry::coordinate_limit))
      by.fail(
          fmt::format("'{}' is {} at vertex {}; accepted: 0 or more, and less than 1e300 times "
                      "the scale, {}",
                      scalar, value, i, scale));
  }
  Radii read(std::move(radii));
  if (read.largest() == 0)
    by.fail(fmt::format("'{}' is 0 everywhere; accepted: a scalar that is above 0 at a vertex",
                        scalar));
  return read;
}

}  // namespace

std::optional<std::string> scalar_of_radius(const JsonNode& object) {
  if (!object.has("radius") || !object["radius"].is_object()) return std::nullopt;
  return by_of(object["radius"]).string();
}

Radii read_radii(const JsonNode& object, const geometry::Vertices& vertices) {
  const JsonNode node = object["radius"];
  if (node.is_object()) return radii_by_scalar(node, vertices);
  return positive(node, "a positive length, world units");
}

}  // namespace pellucid::scene
