// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>

#include "compare/cluster/collect_study.h"
#include "compare/results/result_row.h"

namespace pellucid::app {

/// Prints a cell's errors and costs, or why it failed, as one line.
void print_row(const compare::ResultRow& row);

/// Prints to stderr what is to be known of where the rows come from, a line each.
void print_warnings(std::span<const compare::ResultRow> rows);

/// Throws WorkError that counts the cells that are missing and those that failed, unless there are
/// none; `folder` is where the tables are.
void check_complete(std::span<const compare::ResultRow> rows,
                    std::span<const compare::MissingCell> missing,
                    const std::filesystem::path& folder);

}  // namespace pellucid::app
