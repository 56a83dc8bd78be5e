// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/study/read_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "fields/make_field.h"
#include "scene/files/camera_file.h"

namespace pellucid::compare {

/// {"relative": 0.05, "min": 5, "max": 50, "seconds": 60}. Fewer than five times have no interval.
TimingRule read_timing(const JsonNode& node, int repeats) {
  node.accept_keys({"relative", "min", "max", "seconds"});
  constexpr int fewest = 5, usual_most = 50;
  TimingRule rule{std::max(fewest, repeats), usual_most, 0.05};
  if (node.has("relative")) rule.relative = node["relative"].number(0.001, 1);
  if (node.has("min")) rule.min = node["min"].integer(fewest, max_repeats);
  rule.max = std::max(rule.max, rule.min);
  if (node.has("max")) rule.max = node["max"].integer(rule.min, max_repeats);
  constexpr double a_day = 86400;
  if (node.has("seconds")) rule.seconds = node["seconds"].number(0, a_day);
  return rule;
}

/// true, or {"sizes": [0.25], "margin": 2}.
std::optional<ScreenRule> read_screen_rule(const JsonNode& node) {
  constexpr double smallest = 1.0 / 64, largest = 0.9, largest_margin = 1000;
  ScreenRule rule;
  if (!node.is_object()) return node.boolean() ? std::optional(rule) : std::nullopt;
  node.accept_keys({"sizes", "margin"});
  if (node.has("sizes")) {
    rule.sizes.clear();
    for (const JsonNode& size : node["sizes"].elements())
      rule.sizes.push_back(size.number(smallest, largest));
    if (rule.sizes.empty()) node["sizes"].fail("[]; accepted: at least one part of the size");
  }
  if (node.has("margin")) rule.margin = node["margin"].number(1, largest_margin);
  return rule;
}

/// true, or {"field": NAME, "samples": 4, "factor": 4}. Stages are refined towards the reference.
std::optional<BudgetOptions> read_budget(const JsonNode& node, const Study& study) {
  constexpr int most_samples = 16;
  constexpr double most_factor = 64;
  if (!study.reference.row->promises.exact)
    node.fail(
        fmt::format("the reference, {}, is not exact; accepted: beside one that is, such as "
                    "raytrace",
                    study.reference.text()));
  if (!study.reference_scenes.empty())
    node.fail("beside a 'reference_scene'; accepted: one of the two");
  BudgetOptions options;
  if (!node.is_object()) return node.boolean() ? std::optional(options) : std::nullopt;
  node.accept_keys({"field", "samples", "factor"});
  if (node.has("field")) {
    options.field = node["field"].string();
    at_place(node["field"], [&] { fields::make_field(options.field, study.file.parent_path()); });
  }
  if (node.has("samples")) options.samples = node["samples"].integer(2, most_samples);
  if (node.has("factor")) options.factor = node["factor"].number(2, most_factor);
  return options;
}

/// A number of views on an orbit, "path", or a list of cameras.
Views read_views(const JsonNode& node, const std::filesystem::path& folder) {
  constexpr int most_views = 1000;
  Views views;
  if (node.is_string() && node.string() == "path") {
    views.path = true;
  } else if (node.is_array()) {
    for (const JsonNode& element : node.elements()) {
      views.cameras.push_back(scene::read_camera(element, folder));
      at_place(element, [&] { return scene::camera_frame(views.cameras.back()); });
    }
    if (views.cameras.empty() || views.cameras.size() > std::size_t(most_views))
      node.fail(fmt::format("{} cameras; accepted: 1 to {}", views.cameras.size(), most_views));
  } else if (node.value().is_number()) {
    views.orbit = node.integer(2, most_views);
  } else {
    node.fail("accepted: a number of views on an orbit, \"path\", or a list of cameras");
  }
  return views;
}

}  // namespace pellucid::compare
