// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <span>

#include "compare/results/result_row.h"
#include "compare/study/study.h"

namespace pellucid::compare {

/// Everything that the report's page shows, with the pictures as data URIs: "study", "rows",
/// "scenes", "methods", "claims", "costs" and "error_scale". compare/report/page/report.js reads
/// it.
nlohmann::json report_data(const std::filesystem::path& folder, const Study& study,
                           std::span<const ResultRow> rows);

}  // namespace pellucid::compare
