// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/changes/change_texts.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "compare/results/number_json.h"

namespace pellucid::compare {
namespace {

using nlohmann::json;

std::string_view name_of(CellChange::Kind kind) {
  switch (kind) {
    case CellChange::Kind::changed:
      return "changed";
    case CellChange::Kind::missing:
      return "missing";
    case CellChange::Kind::added:
      return "new";
    default:
      return "same";
  }
}

json number_json(const NumberChange& n) {
  json j{{"title", n.title}, {"before", n.before}, {"after", n.after}, {"time", n.is_time}};
  if (n.better) j["better"] = *n.better;
  return j;
}

json picture_json(const PictureChange& p) {
  if (!p.why_not.empty()) return {{"view", p.view + 1}, {"why_not", p.why_not}};
  return {{"view", p.view + 1},
          {"pixels", p.pixels},
          {"largest", compare::number_json(p.largest)},
          {"first", {p.x, p.y}},
          {"beyond_rounding", p.beyond_rounding()}};
}

json cell_json(const CellChange& cell) {
  json numbers = json::array(), pictures = json::array();
  for (const NumberChange& n : cell.numbers) numbers.push_back(number_json(n));
  for (const PictureChange& p : cell.pictures) pictures.push_back(picture_json(p));
  return {{"cell", cell.cell},
          {"is", name_of(cell.kind)},
          {"numbers", numbers},
          {"pictures", pictures},
          {"causes", cell.causes}};
}

std::string number_line(const NumberChange& n) {
  return fmt::format("{}: {} → {}{}", n.title, n.before, n.after,
                     !n.better   ? ""
                     : *n.better ? ", better"
                                 : ", worse");
}

void add_cell(const CellChange& cell, std::vector<std::string>& lines) {
  if (cell.kind == CellChange::Kind::same) return;
  lines.push_back(heading_line(cell));
  for (const PictureChange& p : cell.pictures) lines.push_back("  " + picture_line(p));
  for (const NumberChange& n : cell.numbers) lines.push_back("  " + number_line(n));
  for (const std::string& cause : cell.causes) lines.push_back("  " + cause_line(cause));
}

}  // namespace

std::string heading_line(const CellChange& cell) {
  return fmt::format("{}: {}", cell.cell, name_of(cell.kind));
}

std::string picture_line(const PictureChange& p) {
  const std::string view = p.view > 0 ? fmt::format("view {}: ", p.view + 1) : "";
  if (!p.why_not.empty()) return fmt::format("{}picture: {}", view, p.why_not);
  return fmt::format("{}picture: {} pixels differ, the first at ({}, {}), by up to {:.3g}{}", view,
                     p.pixels, p.x, p.y, p.largest,
                     p.beyond_rounding() ? "" : ", which is rounding");
}

std::string cause_line(const std::string& cause) { return "since " + cause; }

json to_json(const RunChanges& changes) {
  json cells = json::array();
  for (const CellChange& cell : changes.cells) cells.push_back(cell_json(cell));
  return {{"format", "pellucid-changes"},   {"version", 1},
          {"differ", changes.differ(true)}, {"differ_but_for_times", changes.differ(false)},
          {"warnings", changes.warnings},   {"cells", cells}};
}

std::vector<std::string> lines_of(const RunChanges& changes) {
  std::vector<std::string> lines;
  for (const CellChange& cell : changes.cells) add_cell(cell, lines);
  const auto same = std::count_if(changes.cells.begin(), changes.cells.end(),
                                  [](const auto& c) { return c.kind == CellChange::Kind::same; });
  lines.push_back(fmt::format("{} of {} cells are the same", same, changes.cells.size()));
  return lines;
}

}  // namespace pellucid::compare
