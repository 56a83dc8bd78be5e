// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/study/claims.h"

#include <fmt/format.h>

#include <algorithm>

#include "compare/results/measure_columns.h"

namespace pellucid::compare {
namespace {

std::optional<double> value_of(const ClaimedNumber& number, std::string_view scene,
                               std::string_view call, std::span<const ResultRow> rows) {
  for (const ResultRow& row : rows)
    if (row.error.empty() && row.scene == scene && row.call() == call) return number.of(row);
  return std::nullopt;
}

bool is_better(Better way, double a, double b) { return way == Better::lower ? a < b : a > b; }

/// What has to be said where `better` is not better than `worse` by the factor.
std::optional<std::string> against(const Claim& claim, const std::pair<std::string, double>& better,
                                   const std::pair<std::string, double>& worse) {
  if (claim.factor == 1) {
    if (!is_better(claim.by.better, worse.second, better.second)) return std::nullopt;
    return fmt::format("{} before {}", worse.first, better.first);
  }
  const bool lower = claim.by.better == Better::lower;
  const double here = lower ? worse.second / better.second : better.second / worse.second;
  if (here >= claim.factor) return std::nullopt;
  return fmt::format("{} before {} by a factor of {:.3g}, not {:.3g}", better.first, worse.first,
                     here, claim.factor);
}

/// Holds the values, which follow the claimed order in groups of these sizes, against it.
void check_order(const Claim& claim, std::span<const std::size_t> groups, ClaimCheck& check) {
  std::size_t group_end = 0;
  for (const std::size_t size : groups) {
    const std::size_t group_begin = group_end;
    group_end += size;
    for (std::size_t better = group_begin; better < group_end; ++better)
      for (std::size_t worse = group_end; worse < check.values.size(); ++worse)
        if (auto words = against(claim, check.values[better], check.values[worse]))
          check.against.push_back(std::move(*words));
  }
}

void check_bound(const Claim& claim, ClaimCheck& check) {
  for (const auto& [call, value] : check.values) {
    if (claim.by.better == Better::lower ? value <= *claim.bound : value >= *claim.bound) continue;
    const std::string of = check.values.size() > 1 ? call + " " : "";
    const std::string here = claim.by.text(value), claimed = claim.by.text(*claim.bound);
    check.against.push_back(here == claimed  // but for digits that people are not shown
                                ? fmt::format("{}{}, not {}", of, value, *claim.bound)
                                : fmt::format("{}{}, not {}", of, here, claimed));
  }
}

void hold_against(const Claim& claim, ClaimCheck& check) {
  if (claim.bound) return check_bound(claim, check);
  std::vector<std::size_t> groups;
  for (const auto& group : claim.order) groups.push_back(group.size());
  check_order(claim, groups, check);
}

std::optional<ClaimCheck> check_scene(const Claim& claim, const std::string& scene,
                                      std::span<const ResultRow> rows) {
  ClaimCheck check{scene, {}, {}};
  for (const auto& group : claim.order)
    for (const std::string& call : group) {
      const auto value = value_of(claim.by, scene, call, rows);
      if (!value) return std::nullopt;
      check.values.emplace_back(call, *value);
    }
  hold_against(claim, check);
  return check;
}

ClaimCheck mean_of(const Claim& claim, std::span<const ClaimCheck> checks) {
  ClaimCheck mean{"mean", checks[0].values, {}};
  for (std::size_t i = 0; i < mean.values.size(); ++i) {
    double sum = 0;
    for (const ClaimCheck& check : checks) sum += check.values[i].second;
    mean.values[i].second = sum / double(checks.size());
  }
  hold_against(claim, mean);
  return mean;
}

std::vector<ClaimCheck> check_scene_order(const Claim& claim, std::span<const ResultRow> rows) {
  std::vector<ClaimCheck> checks;
  for (const std::string& call : claim.order.front()) {
    ClaimCheck check{call, {}, {}};
    for (const std::string& scene : claim.scenes)
      if (const auto value = value_of(claim.by, scene, call, rows))
        check.values.emplace_back(scene, *value);
    if (check.values.size() != claim.scenes.size()) continue;
    check_order(claim, std::vector<std::size_t>(claim.scenes.size(), 1), check);
    checks.push_back(std::move(check));
  }
  return checks;
}

}  // namespace

std::optional<double> ClaimedNumber::of(const ResultRow& row) const {
  return column ? column->value(row) : measure_of(row, measure);
}

std::string ClaimedNumber::text(double value) const {
  return column ? number_for_people(column->style, value) : fmt::format("{:.3g}", value);
}

std::string ClaimedNumber::heading() const { return column ? compare::heading(*column) : measure; }

std::vector<ClaimCheck> check_claim(const Claim& claim, std::span<const std::string> scenes,
                                    std::span<const ResultRow> rows) {
  if (claim.orders_scenes) return check_scene_order(claim, rows);
  if (!claim.scenes.empty()) scenes = claim.scenes;
  std::vector<ClaimCheck> checks;
  for (const std::string& scene : scenes)
    if (auto check = check_scene(claim, scene, rows)) checks.push_back(std::move(*check));
  if (checks.size() > 1) checks.push_back(mean_of(claim, checks));
  return checks;
}

}  // namespace pellucid::compare
