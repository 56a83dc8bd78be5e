// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/figure/figure_table.h"

#include <fmt/format.h>

#include "compare/figure/figure_content.h"
#include "compare/figure/figure_numbers.h"
#include "compare/report/tables.h"
#include "compare/results/best_row.h"
#include "compare/results/measure_columns.h"
#include "core/error.h"
#include "core/options/names.h"

namespace pellucid::compare {
namespace {

/// What one scene's rows lack another's may have.
std::vector<Column> columns_of(const FigureRequest& request,
                               const std::vector<FigureRows>& scenes) {
  const std::vector<ResultRow> rows = rows_in(scenes);
  std::vector<Column> chosen;
  for (const std::string& name : request.numbers) chosen.push_back(column_named(name, rows));
  return chosen;
}

std::string interval_text(const Column& column, const ResultRow& row) {
  const std::optional<Interval> interval = interval_of(column, row);
  if (!interval) return "";
  return fmt::format(" {{\\footnotesize({}--{})}}", number_for_people(column.style, interval->low),
                     number_for_people(column.style, interval->high));
}

std::string cell(const Column& column, const ResultRow& row, std::span<const ResultRow> rows) {
  if (!column.value(row) || (row.reference && is_error(column))) return "--";
  const std::string number = latex_runs(plain_number(column, row));
  const std::string interval = interval_text(column, row);
  if (!is_best_of_several(column, row, rows)) return number + interval;
  return fmt::format("{{\\boldmath\\textbf{{{}}}}}{}{}", number,
                     is_only_tied(column, row, rows) ? "$^*$" : "", interval);
}

std::string name_of(const FigureHeading& heading, const ResultRow& row) {
  std::string name = latex_escaped(heading.title);
  if (!heading.parameters.empty())
    name += fmt::format(" {{\\footnotesize {}}}", latex_escaped(heading.parameters));
  return row.reference ? fmt::format("\\textit{{{}}}", name) : name;
}

std::string block(const FigureRows& scene, const std::string& label,
                  const std::vector<FigureHeading>& headings, const std::vector<Column>& columns) {
  std::string text = "    \\midrule\n";
  if (!label.empty())
    text += fmt::format("    \\multicolumn{{{}}}{{l}}{{\\textit{{{}}}}} \\\\\n", columns.size() + 1,
                        latex_escaped(label));
  for (std::size_t i = 0; i < scene.rows.size(); ++i) {
    text += "    " + name_of(headings[i], scene.rows[i]);
    for (const Column& column : columns) text += " & " + cell(column, scene.rows[i], scene.rows);
    text += " \\\\\n";
  }
  return text;
}

}  // namespace

std::string latex_figure_table(const std::vector<FigureRows>& scenes, const FigureRequest& request,
                               const FigureWidth& width, const FigureCaption& caption) {
  const std::vector<Column> columns = columns_of(request, scenes);
  const std::vector<FigureHeading> headings = figure_headings(scenes.front(), request);
  const std::vector<std::string> labels = scene_labels(scenes, request);
  const std::string_view environment = width.is_page ? "table*" : "table";
  std::string text = fmt::format(
      "{}% Needs \\usepackage{{booktabs}}.\n\\begin{{{}}}[t]\n  \\centering\n"
      "  \\caption{{{}}}\n  \\label{{tab:{}}}\n  \\begin{{tabular}}{{l{}}}\n    \\toprule\n    "
      "Method",
      latex_comment(caption.command) + caption.warnings, environment, latex_escaped(caption.text),
      caption.label, std::string(columns.size(), 'r'));
  for (const Column& column : columns) text += " & " + latex_escaped(heading(column));
  text += " \\\\\n";
  for (std::size_t i = 0; i < scenes.size(); ++i)
    text += block(scenes[i], labels[i], headings, columns);
  return text + fmt::format("    \\bottomrule\n  \\end{{tabular}}\n\\end{{{}}}\n", environment);
}

}  // namespace pellucid::compare
