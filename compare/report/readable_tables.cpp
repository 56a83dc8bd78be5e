// SPDX-License-Identifier: GPL-3.0-or-later
// The tables for people: Markdown and LaTeX.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <map>
#include <optional>

#include "compare/report/budget_tables.h"
#include "compare/report/markdown_text.h"
#include "compare/report/tables.h"
#include "compare/results/best_row.h"
#include "compare/results/columns.h"
#include "compare/results/measure_columns.h"
#include "compare/results/provenance.h"
#include "core/error.h"

namespace pellucid::compare {
namespace {

/// The columns that are few enough for a page.
std::span<const Column> table_columns() {
  static const std::vector<Column> chosen = [] {
    std::vector<Column> few;
    for (const Column& column : columns())
      if (column.shown.tables) few.push_back(column);
    return few;
  }();
  return chosen;
}

std::string cell_text(const Column& column, const ResultRow& row) {
  return text_with_interval(column, row);
}

std::vector<ResultRow> rows_of(std::string_view scene, std::span<const ResultRow> rows) {
  std::vector<ResultRow> chosen;
  for (const ResultRow& row : rows)
    if (row.scene == scene) chosen.push_back(row);
  return chosen;
}

/// What sets a row apart from the program's own methods.
std::string_view mark_of(const ResultRow& row) {
  if (row.reference) return " (reference)";
  return row.given.empty() ? "" : " (given)";
}

std::string markdown_line(const ResultRow& row) {
  std::vector<std::string> cells{fmt::format("{}{}", row.call(), mark_of(row))};
  if (!row.error.empty())
    cells.push_back("failed: " + row.error);
  else
    for (const Column& column : table_columns()) cells.push_back(cell_text(column, row));
  return markdown_cells(cells);
}

bool has_interval(const Column& column, const ResultRow& one, const ResultRow& other) {
  return interval_of(column, one) || interval_of(column, other);
}

/// "Time: a and b are tied", a line for each column whose best is not told from others.
std::string markdown_ties(std::span<const ResultRow> rows) {
  std::string text;
  for (const Column& column : table_columns()) {
    const ResultRow* best = best_row(column, rows);
    if (is_undecided(column, rows))
      text += fmt::format(
          "\n{}: not told apart: of fewer than five timed pictures there is no interval.\n",
          column.title);
    std::vector<std::string> tied;
    for (const ResultRow& row : rows)
      if (best && &row != best && has_interval(column, *best, row) &&
          is_among_best(column, row, rows))
        tied.push_back(markdown_escaped(row.call()));
    if (!tied.empty())
      text += fmt::format("\n{}: {} is the best, tied with {}: their 95 % intervals overlap.\n",
                          column.title, markdown_escaped(best->call()), fmt::join(tied, ", "));
  }
  return text;
}

std::string markdown_block(std::string_view scene, std::span<const ResultRow> rows) {
  std::vector<std::string> titles{"Method"};
  for (const Column& column : table_columns()) titles.push_back(heading(column));
  std::string text = markdown_heading("##", scene) + '\n' + markdown_head(titles, 1);
  for (const ResultRow& row : rows) text += markdown_line(row);
  if (const int views = views_of(rows); views > 1)
    text += fmt::format(
        "\nNumbers are means over {} views; the pictures are of view 1, those of others named "
        "so.\n",
        views);
  return text + markdown_ties(rows);
}

/// The rows that a table of measures has as its columns.
std::vector<ResultRow> measured_rows(std::span<const ResultRow> rows) {
  std::vector<ResultRow> measured;
  for (const ResultRow& row : rows)
    if (!row.measures.empty()) measured.push_back(row);
  return measured;
}

std::string measure_text(std::optional<double> value) {
  if (!value) return "–";
  return *value == std::floor(*value) && std::abs(*value) < 1e15 ? fmt::format("{:.0f}", *value)
                                                                 : fmt::format("{:.4g}", *value);
}

/// Many numbers of few methods: a line for each number.
std::string markdown_measures(std::span<const ResultRow> rows) {
  const std::vector<ResultRow> measured = measured_rows(rows);
  if (measured.empty()) return "";
  std::vector<std::string> titles{""};
  for (const ResultRow& row : measured) titles.push_back(row.call());
  std::string text = '\n' + markdown_head(titles, 1);
  for (const scene::Measure& measure : measure_columns(measured)) {
    std::vector<std::string> cells{heading(measure)};
    for (const ResultRow& row : measured)
      cells.push_back(measure_text(measure_of(row, measure.name)));
    text += markdown_cells(cells);
  }
  return text;
}

/// "fourier:bands=5 2.1e-02, …: the same here", a line for each scene.
std::string markdown_claim(const Claim& claim, const Study& study,
                           std::span<const ResultRow> rows) {
  std::string text =
      fmt::format("\n{} ({}):\n\n", markdown_escaped(claim.text), claim.by.heading());
  const std::vector<ClaimCheck> checks = check_claim(claim, scene_names(study), rows);
  for (const ClaimCheck& check : checks) {
    std::string line = check.of + ':';
    for (const ClaimedValue& value : check.values)
      line += fmt::format(" {} {},", value.of, claim.by.text(value.value));
    line.back() = ';';
    text += fmt::format("- {} {}\n", markdown_escaped(line), markdown_escaped(verdict(check)));
  }
  return checks.empty() ? text + "- no scene has all of its numbers\n" : text;
}

/// The first scene of each ladder at which a method breaks, a line for each method.
std::string markdown_ladders(const Study& study, std::span<const ResultRow> rows) {
  const LadderTable table = ladder_table(study.ladders, rows);
  if (table.lines.empty()) return "";
  std::vector<std::string> titles{"Method"};
  titles.insert(titles.end(), table.heads.begin(), table.heads.end());
  std::string text = markdown_heading("##", "Where each method breaks") + '\n' +
                     markdown_head(titles, titles.size());
  for (const auto& [call, cells] : table.lines) {
    std::vector<std::string> line{call};
    line.insert(line.end(), cells.begin(), cells.end());
    text += markdown_cells(line);
  }
  return text;
}

/// The exponents by which costs grow, a table for each size.
std::string markdown_growth(const Study& study, std::span<const ResultRow> rows) {
  std::string text = study.growth.empty() ? "" : "\n" + markdown_heading("##", "How costs grow");
  for (const Growth& growth : study.growth) {
    std::vector<std::string> titles{fmt::format("{}: exponent of", growth.title)};
    std::map<std::string, std::vector<std::string>> cells;
    std::vector<std::string> calls;
    for (std::size_t column = 0; column < growth.by.size(); ++column) {
      titles.push_back(growth.by[column]->title);
      for (const GrowthCurve& curve : growth_curves(growth, *growth.by[column], rows)) {
        std::vector<std::string>& line = cells[curve.call];
        if (line.empty()) calls.push_back(curve.call);
        line.resize(growth.by.size(), "–");
        line[column] = text_of(curve.law);
      }
    }
    text += '\n' + markdown_head(titles, titles.size());
    for (const std::string& call : calls) {
      std::vector<std::string> line{call};
      line.insert(line.end(), cells[call].begin(), cells[call].end());
      text += markdown_cells(line);
    }
  }
  return text;
}

/// 1.23e-04 as $1.23\cdot10^{-4}$.
std::string latex_number(const std::string& text) {
  if (text == "∞") return "$\\infty$";
  if (text.starts_with('>')) return "$>$" + text.substr(1);
  const std::size_t e = text.find('e');
  if (e == std::string::npos) return text;
  return fmt::format("${}\\cdot10^{{{}}}$", text.substr(0, e), std::stoi(text.substr(e + 1)));
}

std::string latex_line(const ResultRow& row, std::span<const ResultRow> rows) {
  std::string line = latex_escaped(row.call()) + (row.given.empty() ? "" : " (given)");
  if (!row.error.empty())
    return line + fmt::format(" & \\multicolumn{{{}}}{{l}}{{failed: {}}} \\\\\n",
                              table_columns().size(), latex_escaped(row.error));
  for (const Column& column : table_columns()) {
    const std::string text = latex_number(cell_text(column, row));
    line += is_among_best(column, row, rows) ? fmt::format(" & {{\\boldmath\\textbf{{{}}}}}", text)
                                             : " & " + text;
  }
  return line + " \\\\\n";
}

std::string latex_block(std::string_view scene, std::span<const ResultRow> rows) {
  std::string text = fmt::format("\\midrule\n\\multicolumn{{{}}}{{l}}{{\\textit{{{}}}}} \\\\\n",
                                 table_columns().size() + 1, latex_escaped(scene));
  for (const ResultRow& row : rows) text += latex_line(row, rows);
  return text;
}

std::string latex_measures(std::string_view scene, std::span<const ResultRow> rows) {
  const std::vector<ResultRow> measured = measured_rows(rows);
  if (measured.empty()) return "";
  std::string text = fmt::format("\n\\begin{{tabular}}{{l{}}}\n\\toprule\n\\textit{{{}}}",
                                 std::string(measured.size(), 'r'), latex_escaped(scene));
  for (const ResultRow& row : measured) text += " & " + latex_escaped(row.call());
  text += " \\\\\n\\midrule\n";
  for (const scene::Measure& measure : measure_columns(measured)) {
    text += latex_escaped(heading(measure));
    for (const ResultRow& row : measured)
      text += " & " + latex_number(measure_text(measure_of(row, measure.name)));
    text += " \\\\\n";
  }
  return text + "\\bottomrule\n\\end{tabular}\n";
}

}  // namespace

std::string latex_escaped(std::string_view text) {
  std::string escaped;
  for (const char c : one_line(text, text.size() + 1)) {
    if (std::string_view("&%$#_{}").find(c) != std::string_view::npos) escaped += '\\';
    escaped += c == '\\'  ? "\\textbackslash{}"
               : c == '~' ? "\\textasciitilde{}"
               : c == '^' ? "\\textasciicircum{}"
               : c == '<' ? "\\textless{}"
               : c == '>' ? "\\textgreater{}"
               : c == '|' ? "\\textbar{}"
                          : std::string(1, c);
  }
  return escaped;
}

std::string latex_comment(std::string_view text) {
  return "% " + one_line(text, text.size() + 1) + '\n';
}

std::string latex_warnings(std::span<const ResultRow> rows) {
  std::string text;
  for (const std::string& warning : provenance_warnings(rows))
    text += latex_comment("Warning: " + warning);
  if (const int views = views_of(rows); views > 1)
    text += latex_comment(fmt::format("Numbers are means over {} views.", views));
  return text;
}

std::string markdown_table(const Study& study, std::span<const ResultRow> rows) {
  std::string text = fmt::format("# {}\n", markdown_escaped(study.title));
  if (!study.source.empty()) text += fmt::format("\n{}\n", markdown_escaped(study.source));
  if (study.opacities)
    text += fmt::format("\nAll composite the opacities of least energy that `{}` finds.\n",
                        study.opacities->text());
  for (const std::string& note : study.notes) text += fmt::format("\n{}\n", markdown_escaped(note));
  for (const std::string& warning : provenance_warnings(rows))
    text += fmt::format("\n**{}**\n", markdown_escaped(warning));
  for (const auto& scene : study.scenes) {
    const std::vector<ResultRow> here = rows_of(scene_name(scene), rows);
    text += markdown_block(scene_name(scene), here) + markdown_measures(here);
  }
  if (!study.claims.empty()) text += "\n## What the source found\n";
  for (const Claim& claim : study.claims) text += markdown_claim(claim, study, rows);
  return text + markdown_budgets(rows) + markdown_ladders(study, rows) +
         markdown_growth(study, rows) + markdown_costs(study, rows);
}

std::string latex_table(const Study& study, std::span<const ResultRow> rows) {
  std::string text = latex_comment(study.title + "; needs \\usepackage{booktabs}");
  text += latex_warnings(rows);
  text += fmt::format("\\begin{{tabular}}{{l{}}}\n\\toprule\nMethod",
                      std::string(table_columns().size(), 'r'));
  for (const Column& column : table_columns()) text += fmt::format(" & {}", heading(column));
  text += " \\\\\n";
  for (const auto& scene : study.scenes)
    text += latex_block(scene_name(scene), rows_of(scene_name(scene), rows));
  text += "\\bottomrule\n\\end{tabular}\n";
  for (const auto& scene : study.scenes)
    text += latex_measures(scene_name(scene), rows_of(scene_name(scene), rows));
  return text + latex_costs(study, rows);
}

}  // namespace pellucid::compare
