// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/commands.h"
#include "compare/run/run_study.h"

namespace pellucid::app {

/// Prints a line of JSON for each cell of the study.
void print_plan(const compare::Study& study, const compare::StudyOptions& options);

/// Computes the cell of that name and prints its row. Throws WorkError when it fails.
void run_cell(const compare::Study& study, const std::string& name,
              const compare::StudyOptions& options, const GlobalOptions& globals);

/// Writes tables and report of the cells that are there. Throws WorkError when some are missing or
/// have failed.
void collect(const compare::Study& study, const compare::StudyOptions& options,
             const GlobalOptions& globals);

}  // namespace pellucid::app
