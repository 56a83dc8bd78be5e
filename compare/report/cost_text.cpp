// SPDX-License-Identifier: GPL-3.0-or-later
// The costs, step by step, as Markdown, LaTeX and CSV.
#include <fmt/format.h>

#include "compare/report/tables.h"

namespace pellucid::compare {
namespace {

std::string milliseconds(double ms) {
  return ms >= 100 ? fmt::format("{:.0f}", ms) : fmt::format("{:.3g}", ms);
}

std::string megabytes(const std::optional<double>& bytes) {
  return bytes ? fmt::format("{:.1f}", *bytes / 1e6) : "–";
}

/// What joins cells, ends a line and marks the bottleneck.
struct Markup {
  std::string_view begin, between, end, bold_begin, bold_end;
};

constexpr Markup markdown{"| ", " | ", " |\n", "**", "**"};
constexpr Markup latex{"", " & ", " \\\\\n", "\\textbf{", "}"};

std::string line_of(const std::vector<std::string>& cells, const Markup& markup) {
  return fmt::format("{}{}{}", markup.begin, fmt::join(cells, markup.between), markup.end);
}

std::vector<std::string> head_of(const CostTable& table) {
  std::vector<std::string> cells{"Scene", "Method", "Memory [MB]", "Total [ms]"};
  for (const std::string& step : table.steps) cells.push_back(step);
  return cells;
}

std::vector<std::string> cells_of(const CostLine& line, const Markup& markup) {
  std::vector<std::string> cells{line.scene, line.call, megabytes(line.bytes),
                                 milliseconds(line.milliseconds)};
  for (std::size_t k = 0; k < line.steps.size(); ++k) {
    const std::string text = line.steps[k] ? milliseconds(*line.steps[k]) : "–";
    cells.push_back(line.bottleneck == k
                        ? fmt::format("{}{}{}", markup.bold_begin, text, markup.bold_end)
                        : text);
  }
  return cells;
}

std::string ratio_text(double ratio) { return fmt::format("{:.3g}", ratio); }

std::vector<std::string> cells_of(const CostRatio& ratio) {
  return {ratio.scene, ratio.call, ratio_text(ratio.here),
          ratio.published ? ratio_text(*ratio.published) : "–"};
}

const std::vector<std::string> ratio_head{"Scene", "Method", "here", "as published"};

std::string rule_of(std::size_t columns) {
  std::string rule = "|---|---|";
  for (std::size_t k = 2; k < columns; ++k) rule += "---:|";
  return rule + '\n';
}

std::string latex_tabular(std::vector<std::vector<std::string>> lines) {
  std::string text = fmt::format("\n\\begin{{tabular}}{{ll{}}}\n\\toprule\n",
                                 std::string(lines.front().size() - 2, 'r'));
  for (std::size_t i = 0; i < lines.size(); ++i) {
    // Numbers, and the bottleneck's markup, stand after the second cell.
    const std::size_t names = i == 0 ? lines[i].size() : 2;
    for (std::size_t k = 0; k < names; ++k) lines[i][k] = latex_escaped(lines[i][k]);
    text += line_of(lines[i], latex) + (i == 0 ? "\\midrule\n" : "");
  }
  return text + "\\bottomrule\n\\end{tabular}\n";
}

}  // namespace

std::string markdown_costs(const Study& study, std::span<const ResultRow> rows) {
  std::string text;
  for (const CostTable& table : cost_tables(study, rows)) {
    text += fmt::format("\n## {}\n\n{}{}", table.title, line_of(head_of(table), markdown),
                        rule_of(4 + table.steps.size()));
    for (const CostLine& line : table.lines) text += line_of(cells_of(line, markdown), markdown);
  }
  const std::vector<CostRatio> ratios = cost_ratios(study, rows);
  if (ratios.empty()) return text;
  text += fmt::format("\n## How many times as long {} takes\n\n{}{}", study.reference.text(),
                      line_of(ratio_head, markdown), rule_of(ratio_head.size()));
  for (const CostRatio& ratio : ratios) text += line_of(cells_of(ratio), markdown);
  return text;
}

std::string latex_costs(const Study& study, std::span<const ResultRow> rows) {
  std::string text;
  for (const CostTable& table : cost_tables(study, rows)) {
    std::vector<std::vector<std::string>> lines{head_of(table)};
    for (const CostLine& line : table.lines) lines.push_back(cells_of(line, latex));
    text += fmt::format("\n% {}", table.title) + latex_tabular(std::move(lines));
  }
  return text;
}

std::string csv_costs(const Study& study, std::span<const ResultRow> rows) {
  std::string text = "table,scene,method,step,milliseconds\n";
  for (const CostTable& table : cost_tables(study, rows))
    for (const CostLine& line : table.lines) {
      const auto add = [&](const std::string& step, double ms) {
        text +=
            fmt::format("\"{}\",{},\"{}\",{},{}\n", table.title, line.scene, line.call, step, ms);
      };
      add("total", line.milliseconds);
      for (std::size_t k = 0; k < line.steps.size(); ++k)
        if (line.steps[k]) add(table.steps[k], *line.steps[k]);
    }
  return text;
}

}  // namespace pellucid::compare
