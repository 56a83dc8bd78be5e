// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/study/claims.h"

#include <algorithm>
#include <optional>

namespace pellucid::compare {
namespace {

std::optional<double> value_of(const Column& column, std::string_view scene, std::string_view call,
                               std::span<const ResultRow> rows) {
  for (const ResultRow& row : rows)
    if (row.error.empty() && row.scene == scene && row.call() == call) return column.value(row);
  return std::nullopt;
}

/// Fills `against` from the values, which follow the claimed order.
void compare_groups(const Claim& claim, ClaimCheck& check) {
  std::size_t group_end = 0;
  for (const auto& group : claim.order) {
    const std::size_t group_begin = group_end;
    group_end += group.size();
    for (std::size_t better = group_begin; better < group_end; ++better)
      for (std::size_t worse = group_end; worse < check.values.size(); ++worse)
        if (is_better(*claim.by, check.values[worse].second, check.values[better].second))
          check.against.emplace_back(check.values[better].first, check.values[worse].first);
  }
}

std::optional<ClaimCheck> check_scene(const Claim& claim, const std::string& scene,
                                      std::span<const ResultRow> rows) {
  ClaimCheck check{scene, {}, {}};
  for (const auto& group : claim.order)
    for (const std::string& call : group) {
      const auto value = value_of(*claim.by, scene, call, rows);
      if (!value) return std::nullopt;
      check.values.emplace_back(call, *value);
    }
  compare_groups(claim, check);
  return check;
}

ClaimCheck mean_of(const Claim& claim, std::span<const ClaimCheck> checks) {
  ClaimCheck mean{"mean", checks[0].values, {}};
  for (std::size_t i = 0; i < mean.values.size(); ++i) {
    double sum = 0;
    for (const ClaimCheck& check : checks) sum += check.values[i].second;
    mean.values[i].second = sum / double(checks.size());
  }
  compare_groups(claim, mean);
  return mean;
}

}  // namespace

std::vector<ClaimCheck> check_claim(const Claim& claim, std::span<const std::string> scenes,
                                    std::span<const ResultRow> rows) {
  std::vector<ClaimCheck> checks;
  for (const std::string& scene : scenes)
    if (auto check = check_scene(claim, scene, rows)) checks.push_back(std::move(*check));
  if (checks.size() > 1) checks.push_back(mean_of(claim, checks));
  return checks;
}

}  // namespace pellucid::compare
