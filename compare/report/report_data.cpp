// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/report/report_data.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "compare/budget/budget_stages.h"
#include "compare/cells/cell.h"
#include "compare/pictures/error_map.h"
#include "compare/pictures/image_file.h"
#include "compare/report/base64.h"
#include "compare/report/crop.h"
#include "compare/report/source_json.h"
#include "compare/results/columns.h"
#include "compare/results/provenance.h"
#include "core/files/output_file.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string data_uri(const fs::path& png) {
  return "data:image/png;base64," + base64(read_text(png));
}

std::string hex(const Vec3& color) {
  const auto byte = [](double c) { return displayed_byte(float(c)); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(color.r), byte(color.g), byte(color.b));
}

/// Enough colours for a gradient that looks like the map.
json error_scale_json() {
  constexpr int stops = 33;
  json colors = json::array();
  for (int i = 0; i < stops; ++i) {
    const double share = double(i) / (stops - 1);
    colors.push_back(hex(
        ErrorScale::color(ErrorScale::min * std::pow(ErrorScale::max / ErrorScale::min, share))));
  }
  return {{"min", ErrorScale::min}, {"max", ErrorScale::max}, {"colors", colors}};
}

const ResultRow* find(std::span<const ResultRow> rows, const Cell& cell) {
  for (const ResultRow& row : rows)
    if (row.scene == cell.scene && row.method == cell.call.row->name &&
        row.parameters == cell.call.parameters.given())
      return &row;
  return nullptr;
}

json column_json(const Column& column) {
  return {{"name", column.name},
          {"title", column.title},
          {"heading", heading(column)},
          {"style", name_of(column.style)},
          {"unit", unit_for_people(column.style)},
          {"factor", in_unit_for_people(column.style, 1)},
          {"better", name_of(column.better)},
          {"card", column.shown.card},
          {"sweeps", column.shown.sweeps},
          {"role", name_of(column.shown.role)}};
}

json columns_json() {
  json list = json::array();
  for (const Column& column : columns())
    if (column.shown.report) list.push_back(column_json(column));
  return list;
}

/// Those over parts of the picture have their definition from the same over all of it.
json metrics_json() {
  json list = json::array();
  for (const MetricRow& metric : metrics())
    if (!metric.on_request && metric.region == Region::all)
      list.push_back({{"symbol", metric.symbol},
                      {"title", metric.title},
                      {"definition", metric.definition},
                      {"citation", metric.citation},
                      {"space", metric.card.space},
                      {"channels", metric.card.channels},
                      {"window", metric.card.window}});
  return list;
}

/// What the page's table shows of a row. JSON has no infinity; the page knows which style has.
json values_json(const ResultRow& row) {
  json values = json::object();
  for (const Column& column : columns()) {
    if (!column.shown.report) continue;
    const std::optional<double> value = column.value(row);
    values[column.name] = value && std::isfinite(*value) ? json(*value) : json();
  }
  return values;
}

/// The intervals of these numbers, where they have one.
json intervals_json(const ResultRow& row) {
  json intervals = json::object();
  for (const Column& column : columns())
    if (const auto interval = interval_of(column, row); interval && column.shown.report)
      intervals[column.name] = {interval->low, interval->high};
  return intervals;
}

json row_json(const Cell& cell, const CellFiles& files, const ResultRow& row) {
  json j = to_json(row);
  j["name"] = cell.call.text();
  j["title"] = cell.call.row->title;
  if (!row.error.empty()) return j;
  j["values"] = values_json(row);
  j["intervals"] = intervals_json(row);
  if (row.budget)
    for (json& stage : j["budget"]["stages"])
      stage["title"] = title_of_stage(stage["stage"].get<std::string>());
  j["picture"] = data_uri(files.preview());
  for (json& picture : j["pictures"])
    picture["source"] = data_uri(files.further(picture["name"].get<std::string>()));
  if (!row.reference) j["error_map"] = data_uri(files.error_map());
  if (fs::exists(files.flip_map())) j["flip_map"] = data_uri(files.flip_map());
  return j;
}

void add_error(const Image& reference, const Image& test, Raster<double>& sum) {
  for (std::size_t i = 0; i < sum.pixels.size(); ++i)
    sum.pixels[i] += pixel_error(reference.pixels[i], test.pixels[i]);
}

/// One scene's part of a study: its cells that are done, the reference first.
struct SceneCells {
  std::string name;
  std::vector<Cell> cells;
};

std::vector<SceneCells> done_scenes(const Study& study, std::span<const ResultRow> rows) {
  std::vector<SceneCells> scenes;
  for (const Cell& cell : expand_cells(study)) {
    const ResultRow* row = find(rows, cell);
    if (cell.reference) scenes.push_back({cell.scene, {}});
    if (row && row->error.empty()) scenes.back().cells.push_back(cell);
  }
  std::erase_if(scenes,
                [](const SceneCells& s) { return s.cells.empty() || !s.cells[0].reference; });
  return scenes;
}

Crop choose_crop(const Study& study, const fs::path& folder, const SceneCells& scene) {
  const Image reference = read_image(CellFiles(folder, scene.cells[0]).picture());
  const auto given = study.crops.find(scene.name);
  if (given != study.crops.end()) return fit_crop(given->second, reference.width, reference.height);
  Raster<double> error(reference.width, reference.height);
  for (const Cell& cell : scene.cells)
    if (!cell.call.row->promises.exact)
      add_error(reference, read_image(CellFiles(folder, cell).picture()), error);
  return worst_crop(error);
}

json scene_json(const Study& study, const fs::path& folder, const SceneCells& scene) {
  const Image reference = read_image(CellFiles(folder, scene.cells[0]).picture());
  const Crop crop = choose_crop(study, folder, scene);
  return {{"name", scene.name},
          {"width", reference.width},
          {"height", reference.height},
          {"crop", {crop.x, crop.y, crop.width, crop.height}}};
}

json methods_json(const Study& study) {
  json methods = json::object();
  for (const Cell& cell : expand_cells(study)) {
    const scene::MethodRow& row = *cell.call.row;
    methods[std::string(row.name)] = {{"title", row.title},
                                      {"citation", row.citation},
                                      {"equations", row.equations},
                                      {"bytes_per_pixel", row.bytes_per_pixel},
                                      {"exact", row.promises.exact}};
  }
  return methods;
}

}  // namespace

json report_data(const fs::path& folder, const Study& study, std::span<const ResultRow> rows) {
  json list = json::array(), scenes = json::array();
  for (const Cell& cell : expand_cells(study))
    if (const ResultRow* row = find(rows, cell))
      list.push_back(row_json(cell, CellFiles(folder, cell), *row));
  for (const SceneCells& scene : done_scenes(study, rows))
    scenes.push_back(scene_json(study, folder, scene));
  return {{"study", study_json(study)},
          {"warnings", provenance_warnings(rows)},
          {"columns", columns_json()},
          {"metrics", metrics_json()},
          {"rows", list},
          {"scenes", scenes},
          {"methods", methods_json(study)},
          {"claims", claims_json(study, rows)},
          {"ladders", ladders_json(study, rows)},
          {"costs", costs_json(study, rows)},
          {"error_scale", error_scale_json()}};
}

}  // namespace pellucid::compare
