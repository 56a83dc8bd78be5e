// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/study/ladders.h"

#include <fmt/format.h>

#include <algorithm>

namespace pellucid::compare {
namespace {

/// False of what is not a number, too.
bool is_within(const Ladder& ladder, double value) {
  return ladder.by.better == Better::lower ? value <= ladder.bound : value >= ladder.bound;
}

std::string head_of(const Ladder& ladder) {
  return fmt::format("{}: {} {} {}", ladder.title, ladder.by.heading(),
                     ladder.by.better == Better::lower ? "above" : "below",
                     ladder.by.text(ladder.bound));
}

std::vector<std::string> calls_of(std::span<const ResultRow> rows) {
  std::vector<std::string> calls;
  for (const ResultRow& row : rows)
    if (!row.reference && std::ranges::find(calls, row.call()) == calls.end())
      calls.push_back(row.call());
  return calls;
}

}  // namespace

BreakPoint break_point(const Ladder& ladder, const std::string& call,
                       std::span<const ResultRow> rows) {
  for (const std::string& scene : ladder.scenes) {
    const ResultRow* row = row_of_cell(scene, call, rows);
    if (!row) return {.measured = false};
    if (!row->error.empty()) return {.scene = scene};
    const std::optional<double> value = ladder.by.of(*row);
    if (!value) return {.measured = false};
    if (!is_within(ladder, *value)) return {.scene = scene, .value = value};
  }
  return {};
}

std::string text_of(const BreakPoint& point, const Ladder& ladder) {
  if (!point.measured) return "–";
  if (!point.scene) return "holds";
  return fmt::format("{} ({})", *point.scene,
                     point.value ? ladder.by.text(*point.value) : "failed");
}

LadderTable ladder_table(std::span<const Ladder> ladders, std::span<const ResultRow> rows) {
  LadderTable table;
  if (ladders.empty()) return table;
  for (const Ladder& ladder : ladders) table.heads.push_back(head_of(ladder));
  for (const std::string& call : calls_of(rows)) {
    std::vector<std::string> texts;
    for (const Ladder& ladder : ladders)
      texts.push_back(text_of(break_point(ladder, call, rows), ladder));
    table.lines.emplace_back(call, std::move(texts));
  }
  return table;
}

}  // namespace pellucid::compare
