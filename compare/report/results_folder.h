// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>

#include "compare/report/report_form.h"
#include "compare/results/result_row.h"
#include "compare/study/study.h"

namespace pellucid::compare {

/// Writes what is made of a study's rows into the folder: results.{csv,json}, table.{md,tex},
/// budget.csv and costs.csv where the study asks for them, report.html. Who writes them into one
/// folder at once, on any machine, does it one after the other. Throws as OutputFile does.
void write_results(const std::filesystem::path& folder, const Study& study,
                   std::span<const ResultRow> rows, const ReportForm& form);

}  // namespace pellucid::compare
