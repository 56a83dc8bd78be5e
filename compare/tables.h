#pragma once

#include <span>
#include <string>

#include "compare/result_row.h"
#include "compare/study.h"

namespace pellucid {

// The rows of a study as text. All tables have the same columns; a number that a row lacks is
// empty.

/// RFC 4180 with \n; columns begin scene, method, parameters, rmse, ssim, psnr, seconds, bytes,
/// fragments, max_layers, and end with the measures that only some methods have, and error. Numbers
/// have all their digits, so that they read back equal.
std::string csv_table(std::span<const ResultRow> rows);

/// For people: few digits, milliseconds and MB, one table per scene; below it another one, on its
/// side, of the measures that only some methods have.
std::string markdown_table(const Study& study, std::span<const ResultRow> rows);

/// For papers: booktabs, one block per scene; the best value of a column (the reference left out)
/// in bold; the measures in a second tabular.
std::string latex_table(const Study& study, std::span<const ResultRow> rows);

/// {"format": "pellucid-results", "version": 1, "study": …, "rows": […]}.
std::string results_json(const Study& study, std::span<const ResultRow> rows);

}  // namespace pellucid
