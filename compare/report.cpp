#include "compare/report.h"

#include <OpenImageIO/strutil.h>
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "compare/cell.h"
#include "compare/crop.h"
#include "compare/error_map.h"
#include "compare/image_file.h"
#include "core/output_file.h"
#include "report_files.h"

namespace pellucid {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string data_uri(const fs::path& png) {
  return "data:image/png;base64," + OIIO::Strutil::base64_encode(read_text(png));
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

json row_json(const Cell& cell, const CellFiles& files, const ResultRow& row) {
  json j = to_json(row);
  j["name"] = cell.call.text();
  j["title"] = cell.call.row->title;
  if (!row.error.empty()) return j;
  j["picture"] = data_uri(files.preview());
  if (!row.reference) j["error_map"] = data_uri(files.error_map());
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
    const MethodRow& row = *cell.call.row;
    methods[std::string(row.name)] = {{"title", row.title},
                                      {"citation", row.citation},
                                      {"equations", row.equations},
                                      {"bytes_per_pixel", row.bytes_per_pixel},
                                      {"exact", row.promises.exact}};
  }
  return methods;
}

json report_json(const fs::path& folder, const Study& study, std::span<const ResultRow> rows) {
  json list = json::array(), scenes = json::array();
  for (const Cell& cell : expand_cells(study))
    if (const ResultRow* row = find(rows, cell))
      list.push_back(row_json(cell, CellFiles(folder, cell), *row));
  for (const SceneCells& scene : done_scenes(study, rows))
    scenes.push_back(scene_json(study, folder, scene));
  return {{"study", {{"name", study.name}, {"title", study.title}, {"source", study.source}}},
          {"rows", list},
          {"scenes", scenes},
          {"methods", methods_json(study)},
          {"error_scale", error_scale_json()}};
}

/// JSON inside a <script> element: no "</script>" may end it early.
std::string inline_json(const json& j) {
  std::string text = j.dump();
  for (std::size_t at = 0; (at = text.find("</", at)) != std::string::npos; at += 3)
    text.replace(at, 2, "<\\/");
  return text;
}

/// A file of the vega packages as a CommonJS module.
std::string vega_module(std::string_view name, std::string_view text) {
  return fmt::format("define(\"{}\", function (exports, module, require) {{{}\n}});\n", name, text);
}

/// Debian's vega comes as one file per package, each of which would overwrite the global `vega` of
/// the others: they are loaded as modules, and vega.js puts them together.
std::string vega_bundle() {
  namespace f = report_files;
  const std::pair<std::string_view, std::string_view> modules[] = {
      {"vega-util", f::vega_util_min_js()},
      {"vega-time", f::vega_time_min_js()},
      {"vega-format", f::vega_format_min_js()},
      {"vega-loader", f::vega_loader_min_js()},
      {"vega-dataflow", f::vega_dataflow_min_js()},
      {"vega-scale", f::vega_scale_min_js()},
      {"vega-canvas", f::vega_canvas_min_js()},
      {"vega-scenegraph", f::vega_scenegraph_min_js()},
      {"vega-statistics", f::vega_statistics_min_js()},
      {"vega-expression", f::vega_expression_min_js()},
      {"vega-selections", f::vega_selection_min_js()},
      {"vega-functions", f::vega_functions_min_js()},
      {"vega-runtime", f::vega_runtime_min_js()},
      {"vega-view", f::vega_view_min_js()},
      {"vega-event-selector", f::vega_event_selector_min_js()},
      {"vega-parser", f::vega_parser_min_js()},
      {"vega-encode", f::vega_encode_min_js()},
      {"vega-transforms", f::vega_transforms_min_js()},
      {"vega-view-transforms", f::vega_view_transforms_min_js()},
      {"vega-label", f::vega_label_min_js()}};
  std::string bundle(f::modules_js());
  for (const auto& [name, text] : modules) bundle += vega_module(name, text);
  return bundle + std::string(f::vega_js());
}

std::string page_script() {
  namespace f = report_files;
  std::string script;
  for (const std::string_view part :
       {f::format_js(), f::pictures_js(), f::viewer_js(), f::plots_js(), f::table_js(),
        f::provenance_js(), f::report_js()})
    script += part;
  return script;
}

/// Puts `text` where the page says {{name}}.
void insert(std::string& page, std::string_view name, std::string_view text) {
  const std::string mark = fmt::format("{{{{{}}}}}", name);
  const std::size_t at = page.find(mark);
  page.replace(at, mark.size(), text);
}

std::string html_escaped(std::string_view text) {
  std::string escaped;
  for (const char c : text)
    escaped += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  return escaped;
}

}  // namespace

void write_report(const fs::path& folder, const Study& study, std::span<const ResultRow> rows) {
  // The data comes last: nothing that it holds is taken for a mark.
  std::string page(report_files::report_html());
  insert(page, "title", html_escaped(study.title));
  insert(page, "css", report_files::report_css());
  insert(page, "vega", vega_bundle());
  insert(page, "script", page_script());
  insert(page, "data", inline_json(report_json(folder, study, rows)));
  write_text(folder / "report.html", page);
}

}  // namespace pellucid
