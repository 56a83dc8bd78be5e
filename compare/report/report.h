// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>

#include "compare/report/report_form.h"
#include "compare/results/result_row.h"
#include "compare/study/study.h"

namespace pellucid::compare {

/// Writes FOLDER/report.html, which holds its plots and scripts and asks no other host for
/// anything. As one file it holds its pictures too, and their floats where all of it stays below
/// `form.most_bytes`: exact ones, else rounded to 15 bits of mantissa, else none. In a folder
/// pictures stay in FOLDER/images, and FOLDER/report/ has the floats, exact. Of its own accord it
/// is one file, unless its pictures alone are larger than that.
void write_report(const std::filesystem::path& folder, const Study& study,
                  std::span<const ResultRow> rows, const ReportForm& form = {});

}  // namespace pellucid::compare
