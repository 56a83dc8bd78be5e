// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "compare/study/study.h"
#include "core/files/json_node.h"

namespace pellucid::compare {

// The values of a study's keys that are objects of their own. All throw InputError that names the
// key and what is accepted.

/// A picture is timed so often at most.
inline constexpr int max_repeats = 1000;

/// Reads "timing". Fewer than five times have no interval.
TimingRule read_timing(const JsonNode& node, int repeats);

/// Reads "screen"; nothing for `false`.
std::optional<ScreenRule> read_screen_rule(const JsonNode& node);

/// Reads "budget"; nothing for `false`. Stages are refined towards the study's reference, which has
/// to be read already.
std::optional<BudgetOptions> read_budget(const JsonNode& node, const Study& study);

/// Reads "views".
Views read_views(const JsonNode& node, const std::filesystem::path& folder);

}  // namespace pellucid::compare
