// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/report/report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "compare/report/report_data.h"
#include "core/files/output_file.h"
#include "report_files.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;

/// JSON inside a <script> element: no "</script>" may end it early.
std::string inline_json(const nlohmann::json& j) {
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
       {f::format_js(), f::pictures_js(), f::measures_js(), f::viewer_js(), f::trade_off_js(),
        f::plots_js(), f::curves_js(), f::table_js(), f::claims_js(), f::costs_js(),
        f::overview_js(), f::provenance_js(), f::report_js()})
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
  insert(page, "data", inline_json(report_data(folder, study, rows)));
  write_text(folder / "report.html", page);
}

}  // namespace pellucid::compare
