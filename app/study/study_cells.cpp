// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/study/study_cells.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/study/print_rows.h"
#include "compare/cluster/collect_study.h"
#include "compare/cluster/compute_cell.h"
#include "compare/cluster/study_plan.h"
#include "compare/report/tables.h"
#include "core/error.h"
#include "core/files/json_text.h"

namespace pellucid::app {

void print_plan(const compare::Study& study, const compare::StudyOptions& options) {
  for (const compare::PlannedCell& planned : compare::plan_study(study, options))
    fmt::print("{}\n", compare::plan_line(planned));
}

void run_cell(const compare::Study& study, const std::string& name,
              const compare::StudyOptions& options, const GlobalOptions& globals) {
  const compare::ResultRow row = compare::compute_cell(study, name, options);
  if (globals.json)
    fmt::print("{}\n", json_text(compare::to_json(row), 1));
  else if (!globals.quiet)
    print_row(row);
  if (!row.error.empty()) throw WorkError(fmt::format("{}: {}", name, row.error));
}

void collect(const compare::Study& study, const compare::StudyOptions& options,
             const GlobalOptions& globals) {
  const compare::Collection collection = compare::collect_study(study, options);
  if (globals.json)
    fmt::print("{}", compare::results_json(study, collection.rows));
  else if (!globals.quiet)
    fmt::print("{} cells collected; report: {}\n", collection.rows.size(),
               (options.folder / "report.html").string());
  print_warnings(collection.rows);
  check_complete(collection.rows, collection.missing, options.folder);
}

}  // namespace pellucid::app
