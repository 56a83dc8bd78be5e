// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "compare/conform/conform.h"

namespace pellucid::compare {

/// Returns {"families": …, "cases": …}: how far a renderer comes in each family, and what became of
/// each case.
nlohmann::ordered_json json_of(const std::vector<CaseResult>& results);

}  // namespace pellucid::compare
