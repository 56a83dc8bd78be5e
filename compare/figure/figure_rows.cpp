// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/figure/figure_rows.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "core/options/names.h"
#include "core/options/split.h"

namespace pellucid::compare {
namespace {

bool holds(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

/// Each once, in the order of the first row that has it.
template <class Name>
std::vector<std::string> names_of(std::span<const ResultRow> rows, const Name& name) {
  std::vector<std::string> names;
  for (const ResultRow& row : rows)
    if (!holds(names, name(row))) names.push_back(name(row));
  return names;
}

[[noreturn]] void refuse_name(std::string_view option, std::string_view kind,
                              const std::string& name, const std::vector<std::string>& known) {
  throw InputError(fmt::format(
      "{}: {}", option,
      unknown_name(kind, name, std::vector<std::string_view>(known.begin(), known.end()))));
}

std::vector<std::string> scenes_of(const PastRun& run, const FigureRequest& request) {
  const auto known = names_of(run.rows, [](const ResultRow& row) { return row.scene; });
  std::vector<std::string> scenes;
  for (const std::string& text : request.scenes)
    if (holds(known, text))  // a file's name may hold a comma
      scenes.push_back(text);
    else
      for (const std::string_view name : split(text, ',')) scenes.emplace_back(name);
  for (const std::string& scene : scenes)
    if (!holds(known, scene)) refuse_name("--scene", "scene", scene, known);
  return scenes.empty() ? known : scenes;
}

/// The rows of a scene, the reference first, as the study has them.
std::vector<ResultRow> rows_of_scene(const PastRun& run, const std::string& scene) {
  std::vector<ResultRow> rows;
  for (const ResultRow& row : run.rows)
    if (row.scene == scene) rows.push_back(row);
  return rows;
}

/// A call as it stands, or all calls of a method.
std::vector<std::string> calls_named(const std::string& name, std::span<const ResultRow> rows) {
  const auto known = names_of(rows, [](const ResultRow& row) { return row.call(); });
  if (holds(known, name)) return {name};
  std::vector<std::string> calls;
  for (const ResultRow& row : rows)
    if (row.method == name) calls.push_back(row.call());
  if (calls.empty()) refuse_name("--methods", "method", name, known);
  return calls;
}

std::vector<std::string> calls_of(std::span<const ResultRow> rows, const FigureRequest& request) {
  std::vector<std::string> calls;
  const auto take = [&](const std::string& name) {
    for (const std::string& call : calls_named(name, rows)) calls.push_back(call);
  };
  const auto known = names_of(rows, [](const ResultRow& row) { return row.call(); });
  if (request.methods.empty()) return known;
  for (const std::string& text : request.methods)
    if (holds(known, text))  // a name from elsewhere may hold a comma
      take(text);
    else
      for (const std::string& name : methods_of_text(text)) take(name);
  return calls;
}

const ResultRow& finished_row(const PastRun& run, const std::string& scene,
                              const std::string& call) {
  const std::string name = scene + "/" + call;
  const ResultRow* row = find_row_of(run, name);
  if (!row)
    throw InputError(fmt::format("{}: has no cell {}; accepted: --methods that every --scene has",
                                 run.folder.string(), name));
  if (!row->error.empty())
    throw InputError(fmt::format("{}: {} failed: {}; accepted: --methods whose cells are done",
                                 run.folder.string(), name, one_line(row->error, 200)));
  return *row;
}

std::optional<ResultRow> reference_of(const PastRun& run, const std::string& scene) {
  for (const ResultRow& row : run.rows)
    if (row.scene == scene && row.reference && row.error.empty()) return row;
  return std::nullopt;
}

}  // namespace

std::vector<std::string> methods_of_text(std::string_view text) {
  std::vector<std::string> calls;
  for (const std::string_view part : split_outside_parentheses(text, ',')) {
    const bool goes_on = part.find('=') < part.find(':');
    if (goes_on && !calls.empty())
      calls.back().append(",").append(part);
    else
      calls.emplace_back(part);
  }
  return calls;
}

std::vector<FigureRows> find_figure_rows(const PastRun& run, const FigureRequest& request) {
  if (run.rows.empty()) throw InputError(fmt::format("{}: has no rows yet", run.folder.string()));
  const std::vector<std::string> scenes = scenes_of(run, request);
  const std::vector<std::string> calls = calls_of(rows_of_scene(run, scenes.front()), request);
  std::vector<FigureRows> found;
  for (const std::string& scene : scenes) {
    FigureRows rows{scene, reference_of(run, scene), {}};
    for (const std::string& call : calls) rows.rows.push_back(finished_row(run, scene, call));
    found.push_back(std::move(rows));
  }
  return found;
}

std::vector<ResultRow> rows_in(const std::vector<FigureRows>& scenes) {
  std::vector<ResultRow> rows;
  for (const FigureRows& scene : scenes)
    rows.insert(rows.end(), scene.rows.begin(), scene.rows.end());
  return rows;
}

}  // namespace pellucid::compare
