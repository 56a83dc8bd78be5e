// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/report/report_data.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "compare/budget/budget_stages.h"
#include "compare/cells/cell.h"
#include "compare/pictures/error_map.h"
#include "compare/pictures/image_file.h"
#include "compare/report/column_json.h"
#include "compare/report/crop.h"
#include "compare/report/page_texts.h"
#include "compare/report/source_json.h"
#include "compare/report/url_text.h"
#include "compare/report/view_pictures.h"
#include "compare/results/columns.h"
#include "compare/results/number_json.h"
#include "compare/results/provenance.h"
#include "readers/pictures/picture_file.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string hex(const Vec3& color) {
  const auto byte = [](double c) { return displayed_byte(float(c)); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(color.r), byte(color.g), byte(color.b));
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

/// What the page's table shows of a row.
json values_json(const ResultRow& row) {
  json values = json::object();
  for (const Column& column : columns()) {
    if (!column.shown.report) continue;
    values[column.name] = number_json(column.value(row));
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

/// A picture of a page of one file stands in it; that of a folder's page beside it.
std::string source_of(const fs::path& png, const fs::path& folder, bool in_folder) {
  return in_folder ? url_of(png.lexically_relative(folder)) : data_uri(png);
}

void add_pictures(const ReportCell& cell, const fs::path& folder, bool in_folder, json& j) {
  const auto source = [&](const fs::path& png) { return source_of(png, folder, in_folder); };
  j["picture"] = source(cell.files.preview());
  for (json& picture : j["pictures"])
    picture["source"] = source(cell.files.further(picture["name"].get<std::string>()));
  if (!cell.row->reference) j["error_map"] = source(cell.files.error_map());
  if (fs::exists(cell.files.flip_map())) j["flip_map"] = source(cell.files.flip_map());
  j["has_layers"] = fs::exists(cell.files.layers());
}

json row_json(const ReportCell& cell, const fs::path& folder, bool in_folder) {
  json j = to_json(*cell.row);
  j["name"] = cell.cell.call.text();
  j["title"] = cell.cell.call.row->title;
  if (!cell.is_done()) return j;
  j["values"] = values_json(*cell.row);
  j["intervals"] = intervals_json(*cell.row);
  if (cell.row->budget)
    for (json& stage : j["budget"]["stages"])
      stage["title"] = title_of_stage(stage["stage"].get<std::string>());
  add_pictures(cell, folder, in_folder, j);
  return j;
}

void add_error(const Image& reference, const Image& test, Raster<double>& sum) {
  for (std::size_t i = 0; i < sum.pixels.size(); ++i)
    sum.pixels[i] += pixel_error(reference.pixels[i], test.pixels[i]);
}

/// The places in the list of each scene's cells that are done, the reference first; only of scenes
/// whose reference is.
std::vector<std::vector<std::size_t>> done_scenes(std::span<const ReportCell> cells) {
  std::vector<std::vector<std::size_t>> scenes;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!cells[i].is_done()) continue;
    if (cells[i].cell.reference)
      scenes.push_back({i});
    else if (cells[i].reference != i)
      scenes.back().push_back(i);
  }
  return scenes;
}

Crop choose_crop(const Study& study, std::span<const ReportCell> cells,
                 std::span<const std::size_t> scene) {
  const ReportCell& first = cells[scene[0]];
  const Image reference = read_image(first.files.picture());
  if (const auto given = study.crops.find(first.cell.scene); given != study.crops.end())
    if (const auto crop = fit_crop(given->second, reference.width, reference.height)) return *crop;
  Raster<double> error(reference.width, reference.height);
  for (const std::size_t i : scene)
    if (!cells[i].cell.call.row->promises.exact)
      add_error(reference, read_image(cells[i].files.picture()), error);
  return worst_crop(error);
}

json scene_json(const Study& study, std::span<const ReportCell> cells,
                std::span<const std::size_t> scene) {
  const ReportCell& first = cells[scene[0]];
  const Image reference = read_image(first.files.picture());
  const Crop crop = choose_crop(study, cells, scene);
  return {{"name", first.cell.scene},
          {"width", reference.width},
          {"height", reference.height},
          {"crop", {crop.x, crop.y, crop.width, crop.height}},
          {"camera", readers::read_picture_text(first.files.picture(), "Camera")}};
}

/// The parameters that are one of several names, which have no order.
json choices_of(const scene::MethodRow& row) {
  json names = json::array();
  for (const ParameterSpec& spec : row.parameters)
    if (spec.kind == ParameterSpec::Kind::choice) names.push_back(spec.name);
  return names;
}

json methods_json(const Study& study) {
  json methods = json::object();
  for (const Cell& cell : expand_cells(study)) {
    const scene::MethodRow& row = *cell.call.row;
    methods[std::string(row.name)] = {
        {"title", row.title},         {"citation", row.citation},
        {"equations", row.equations}, {"bytes_per_pixel", row.bytes_per_pixel},
        {"choices", choices_of(row)}, {"exact", row.promises.exact}};
  }
  return methods;
}

}  // namespace

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

json report_data(const fs::path& folder, const Study& study, std::span<const ResultRow> rows,
                 std::span<const ReportCell> cells, bool in_folder) {
  json list = json::array(), scenes = json::array();
  const bool has_views = in_folder || count_view_pictures(cells) <= most_view_pictures;
  for (const ReportCell& cell : cells) {
    list.push_back(row_json(cell, folder, in_folder));
    if (has_views && cell.is_done())
      list.back()["view_pictures"] = view_pictures(cell, folder, in_folder);
  }
  for (const std::vector<std::size_t>& scene : done_scenes(cells))
    scenes.push_back(scene_json(study, cells, scene));
  return {{"study", study_json(study)},
          {"warnings", provenance_warnings(rows)},
          {"columns", columns_json()},
          {"metrics", metrics_json()},
          {"rows", list},
          {"scenes", scenes},
          {"methods", methods_json(study)},
          {"claims", claims_json(study, rows)},
          {"ladders", ladders_json(study, rows)},
          {"growth", growth_json(study, rows)},
          {"costs", costs_json(study, rows)},
          {"inputs", inputs_json(study)},
          {"error_scale", error_scale_json()}};
}

}  // namespace pellucid::compare
