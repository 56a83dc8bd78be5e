// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/compare_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

#include "compare/changes/changes.h"
#include "compare/changes/changes_page.h"
#include "core/error.h"
#include "core/files/files_read.h"
#include "core/files/json_text.h"

namespace pellucid::app {

namespace fs = std::filesystem;

void add_run_options(CLI::App& command, CompareRunsOptions& options) {
  command
      .add_option("--output", options.output,
                  "Folder for a page with the pictures that differ, side by side, and changes.json")
      ->group("Two runs of a study");
  command
      .add_flag("--ignore-times", options.ignore_times,
                "Times and memory that differ are told, but do not make the runs differ")
      ->group("Two runs of a study");
}

void compare_run_folders(const fs::path& before, const fs::path& after,
                         const CompareRunsOptions& options, const GlobalOptions& globals) {
  const ProtectedInputs protected_inputs;
  const compare::PastRun first = compare::read_past_run(before);
  const compare::PastRun second = compare::read_past_run(after);
  const compare::RunChanges changes = compare::compare_runs(first, second);
  if (!options.output.empty()) compare::write_changes(options.output, changes, first, second);
  if (globals.json)
    fmt::print("{}\n", json_text(compare::to_json(changes), 1));
  else
    for (const std::string& line : compare::lines_of(changes)) fmt::print("{}\n", line);
  for (const std::string& warning : changes.warnings)  // which names of files are in
    std::cerr << "pellucid: " << one_line(warning, warning.size() + 1) << '\n';
  if (changes.differ(!options.ignore_times))
    throw WorkError(fmt::format("{} differs from {}", after.string(), before.string()));
}

}  // namespace pellucid::app
