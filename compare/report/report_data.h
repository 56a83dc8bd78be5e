// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <span>

#include "compare/report/report_cells.h"

namespace pellucid::compare {

/// Everything that the report's page shows, with the pictures as data URIs or, of a page in a
/// folder, as paths from there: "study", "rows", "scenes", "methods", "claims", "costs",
/// "error_scale" and more. compare/report/page/report.js reads it.
nlohmann::json report_data(const std::filesystem::path& folder, const Study& study,
                           std::span<const ResultRow> rows, std::span<const ReportCell> cells,
                           bool in_folder);

/// Returns the ErrorScale as a page draws it: {"min", "max", "colors"}, enough "#rrggbb" for a
/// gradient that looks like it.
nlohmann::json error_scale_json();

}  // namespace pellucid::compare
