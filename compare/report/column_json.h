// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "compare/results/columns.h"

namespace pellucid::compare {

/// Returns what the report's page knows of a column: its names, style, unit and where it appears.
nlohmann::json column_json(const Column& column);

}  // namespace pellucid::compare
