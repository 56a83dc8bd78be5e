// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/report/budget_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/budget/budget_stages.h"
#include "compare/report/markdown_text.h"
#include "compare/report/tables.h"

namespace pellucid::compare {
namespace {

bool has_budget(const ResultRow& row) { return row.budget.has_value(); }

/// Whether the times with and without the stage are told apart.
bool is_decided(const BudgetLine& line) { return !std::isnan(line.seconds); }

/// Nothing where the finer picture takes no longer: there the gain costs nothing; nor where times
/// are not told apart.
std::optional<double> slope(const BudgetLine& line) {
  return line.seconds > 0 ? std::optional(line.gain / line.seconds) : std::nullopt;
}

std::string csv_line(const BudgetLine& line) {
  if (!line.why_not.empty())
    return fmt::format("{},,,,,,,,,{}\n", line.stage, csv_field(line.why_not));
  return fmt::format("{},{},{},{},{},{},{},{},{},\n", line.stage, csv_field(line.refinement),
                     line.share, line.first, line.last, line.rmse, line.gain,
                     csv_digits(is_decided(line) ? std::optional(line.seconds) : std::nullopt),
                     csv_digits(slope(line)));
}

std::string csv_budget(const ResultRow& row) {
  const std::string cell = fmt::format("{},{},{},", csv_field(row.scene), csv_field(row.method),
                                       csv_field(row.parameters));
  std::string text;
  for (const BudgetLine& line : row.budget->lines) text += cell + csv_line(line);
  text += fmt::format("{}interaction,,{},,,,,,,\n", cell, row.budget->interaction);
  return text + fmt::format("{}whole,,1,,,{},,{},,\n", cell, row.budget->rmse, row.budget->seconds);
}

/// What a gain costs, for people.
std::string price_text(const BudgetLine& line) {
  if (!is_decided(line)) return "undecided";
  const std::optional<double> price = slope(line);
  return price ? fmt::format("{:.3g}", *price) : "free";
}

std::string percent(double share) { return fmt::format("{:.1f} %", 100 * share); }

std::string markdown_line(const BudgetLine& line) {
  return markdown_cells(std::vector<std::string>{
      std::string(title_of_stage(line.stage)), percent(line.share),
      fmt::format("{} … {}", percent(std::min(line.first, line.last)),
                  percent(std::max(line.first, line.last))),
      fmt::format("{:.2e}", line.rmse), fmt::format("{:.2e}", line.gain),
      is_decided(line) ? fmt::format("{:+.3g}", line.seconds) : "undecided", price_text(line),
      line.refinement});
}

std::string markdown_budget(const ResultRow& row) {
  const ErrorBudget& budget = *row.budget;
  std::string text = fmt::format(
      "{}\n"
      "RMSE {:.3e} against all stages refined; {:.3g} s as drawn. A gain's price is undecided "
      "where "
      "the intervals of the two times overlap, or one has none.\n\n"
      "| Stage | Share | alone … last | RMSE | Gain | More [s] | Gain per s | Refined to |\n"
      "|---|---:|---:|---:|---:|---:|---:|---|\n",
      markdown_heading("###",
                       fmt::format("Where the error of {}/{} comes from", row.scene, row.call())),
      budget.rmse, budget.seconds);
  std::string others;
  for (const BudgetLine& line : budget.lines)
    (line.why_not.empty() ? text : others) +=
        line.why_not.empty() ? markdown_line(line)
                             : fmt::format("- {}: not here: {}\n", title_of_stage(line.stage),
                                           markdown_escaped(line.why_not));
  text += fmt::format("| Interaction of three or more | {} | | | | | | |\n",
                      percent(budget.interaction));
  return text + (others.empty() ? "" : "\n" + others);
}

}  // namespace

std::string csv_budgets(std::span<const ResultRow> rows) {
  if (std::ranges::none_of(rows, has_budget)) return "";
  std::string text =
      "scene,method,parameters,stage,refinement,share,share_first,share_last,rmse,gain,seconds,"
      "gain_per_second,why_not\n";
  for (const ResultRow& row : rows)
    if (row.budget) text += csv_budget(row);
  return text;
}

std::string markdown_budgets(std::span<const ResultRow> rows) {
  if (std::ranges::none_of(rows, has_budget)) return "";
  std::string text = "\n## Where the error comes from\n";
  for (const ResultRow& row : rows)
    if (row.budget) text += markdown_budget(row);
  return text;
}

}  // namespace pellucid::compare
