// SPDX-License-Identifier: GPL-3.0-or-later
// The costs, step by step, as Markdown, LaTeX and CSV.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "compare/report/markdown_text.h"
#include "compare/report/tables.h"

namespace pellucid::compare {
namespace {

std::string milliseconds(const std::optional<double>& ms) {
  if (!ms) return "–";
  return *ms >= 100 ? fmt::format("{:.0f}", *ms) : fmt::format("{:.3g}", *ms);
}

std::string megabytes(const std::optional<double>& bytes) {
  if (!bytes) return "–";
  return *bytes >= 1e6 ? fmt::format("{:.1f}", *bytes / 1e6) : fmt::format("{:.2g}", *bytes / 1e6);
}

/// What marks the bottleneck.
struct Markup {
  std::string_view bold_begin, bold_end;
};

constexpr Markup markdown{"**", "**"};
constexpr Markup latex{"\\textbf{", "}"};

std::vector<std::string> head_of(const CostTable& table) {
  std::vector<std::string> cells{"Scene", "Method", "Memory [MB]", "Total [ms]"};
  for (const std::string& step : table.steps) cells.push_back(step);
  return cells;
}

std::vector<std::string> cells_of(const CostLine& line, const Markup& markup) {
  std::vector<std::string> cells{line.scene, line.call, megabytes(line.bytes),
                                 milliseconds(line.milliseconds)};
  for (std::size_t k = 0; k < line.steps.size(); ++k) {
    const std::string text = milliseconds(line.steps[k]);
    cells.push_back(line.bottleneck == k
                        ? fmt::format("{}{}{}", markup.bold_begin, text, markup.bold_end)
                        : text);
  }
  return cells;
}

std::string ratio_text(const std::optional<double>& ratio) {
  return ratio ? fmt::format("{:.3g}", *ratio) : "–";
}

std::vector<std::string> cells_of(const CostRatio& ratio) {
  return {ratio.scene, ratio.call, ratio_text(ratio.here), ratio_text(ratio.published)};
}

const std::vector<std::string> ratio_head{"Scene", "Method", "here", "as published"};

std::string latex_tabular(std::vector<std::vector<std::string>> lines) {
  std::string text = fmt::format("\\begin{{tabular}}{{ll{}}}\n\\toprule\n",
                                 std::string(lines.front().size() - 2, 'r'));
  for (std::size_t i = 0; i < lines.size(); ++i) {
    // Numbers, and the bottleneck's markup, stand after the second cell.
    const std::size_t names = i == 0 ? lines[i].size() : 2;
    for (std::size_t k = 0; k < names; ++k) lines[i][k] = latex_escaped(lines[i][k]);
    text += fmt::format("{} \\\\\n{}", fmt::join(lines[i], " & "), i == 0 ? "\\midrule\n" : "");
  }
  return text + "\\bottomrule\n\\end{tabular}\n";
}

}  // namespace

std::string markdown_costs(const Study& study, std::span<const ResultRow> rows) {
  std::string text;
  for (const CostTable& table : cost_tables(study, rows)) {
    text += markdown_heading("##", table.title) + '\n' + markdown_head(head_of(table), 2);
    for (const CostLine& line : table.lines) text += markdown_cells(cells_of(line, markdown));
  }
  const std::vector<CostRatio> ratios = cost_ratios(study, rows);
  if (ratios.empty()) return text;
  text += markdown_heading("##",
                           fmt::format("How many times as long {} takes", study.reference.text()));
  text += '\n' + markdown_head(ratio_head, 2);
  for (const CostRatio& ratio : ratios) text += markdown_cells(cells_of(ratio));
  return text;
}

std::string latex_costs(const Study& study, std::span<const ResultRow> rows) {
  std::string text;
  for (const CostTable& table : cost_tables(study, rows)) {
    std::vector<std::vector<std::string>> lines{head_of(table)};
    for (const CostLine& line : table.lines) lines.push_back(cells_of(line, latex));
    text += '\n' + latex_comment(table.title) + latex_tabular(std::move(lines));
  }
  return text;
}

std::string csv_costs(const Study& study, std::span<const ResultRow> rows) {
  std::string text = "table,scene,method,step,milliseconds\n";
  for (const CostTable& table : cost_tables(study, rows))
    for (const CostLine& line : table.lines) {
      const auto add = [&](const std::string& step, const std::optional<double>& ms) {
        text += fmt::format("{},{},{},{},{}\n", csv_field(table.title), csv_field(line.scene),
                            csv_field(line.call), csv_field(step), csv_digits(ms));
      };
      add("total", line.milliseconds);
      for (std::size_t k = 0; k < line.steps.size(); ++k)
        if (line.steps[k]) add(table.steps[k], line.steps[k]);
    }
  return text;
}

}  // namespace pellucid::compare
