// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>

#include "compare/results/result_row.h"
#include "compare/study/study.h"

namespace pellucid::compare {

/// Writes FOLDER/report.html: one file that holds its pictures, plots and scripts and asks for
/// nothing else.
void write_report(const std::filesystem::path& folder, const Study& study,
                  std::span<const ResultRow> rows);

}  // namespace pellucid::compare
