// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "compare/results/result_row.h"
#include "compare/study/study.h"

namespace pellucid::compare {

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

/// Writes the costs where a study gives its source's: every method's memory, time and time of each
/// step, the longest in bold; the source's; and the reference's time over the others', here and
/// there. Returns an empty text where it gives none.
///@{
std::string markdown_costs(const Study& study, std::span<const ResultRow> rows);
std::string latex_costs(const Study& study, std::span<const ResultRow> rows);
///@}

/// A line for each step: table, scene, method, step, milliseconds.
std::string csv_costs(const Study& study, std::span<const ResultRow> rows);

/// Returns a text as a field of CSV, quoted when it has to be. What a spreadsheet would take for a
/// formula gets an apostrophe, which it takes for the mark of a text.
std::string csv_field(std::string text);

/// Returns the shortest text that reads back as the same double, "inf" for the PSNR of equal
/// pictures; empty where there is no value.
std::string csv_digits(const std::optional<double>& value);

/// Escapes a text so that LaTeX prints it as it stands.
std::string latex_escaped(std::string_view text);

/// Returns a line of comment of LaTeX.
std::string latex_comment(std::string_view text);

/// Returns lines of comment that say over how many views numbers are means, and what
/// provenance_warnings() has to say of them: the author of a paper reads them, not its readers.
std::string latex_warnings(std::span<const ResultRow> rows);

/// {"format": "pellucid-results", "version": 1, "study": …, "rows": […]}.
std::string results_json(const Study& study, std::span<const ResultRow> rows);

}  // namespace pellucid::compare
