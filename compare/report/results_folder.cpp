// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/report/results_folder.h"

#include "compare/report/budget_tables.h"
#include "compare/report/report.h"
#include "compare/report/tables.h"
#include "core/files/file_lock.h"
#include "core/files/output_file.h"

namespace pellucid::compare {

// A report in a folder takes away what an earlier one has left: two at once would take each
// other's.
void write_results(const std::filesystem::path& folder, const Study& study,
                   std::span<const ResultRow> rows, const ReportForm& form) {
  const FileLock one_at_a_time(folder / ".results.lock");
  write_text(folder / "results.csv", csv_table(rows));
  write_text(folder / "results.json", results_json(study, rows));
  write_text(folder / "table.md", markdown_table(study, rows));
  write_text(folder / "table.tex", latex_table(study, rows));
  if (study.budget) write_text(folder / "budget.csv", csv_budgets(rows));
  if (study.published) write_text(folder / "costs.csv", csv_costs(study, rows));
  write_report(folder, study, rows, form);
}

}  // namespace pellucid::compare
