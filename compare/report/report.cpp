// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/report/report.h"

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>

#include "compare/report/html_text.h"
#include "compare/report/report_data.h"
#include "core/files/json_text.h"
#include "core/files/output_file.h"
#include "report_files.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;

/// JSON inside a <script> element: no "</script>" may end it early, no "<!--" change how it is
/// read.
std::string inline_json(const nlohmann::json& j) {
  std::string text;
  for (const char c : json_text(j)) {
    if (c == '<')
      text += "\\u003c";
    else
      text += c;
  }
  return text;
}

/// What follows the last slash of an embedded file's path.
std::string_view stem_of(const report_files::File& file) {
  return file.path.substr(file.path.rfind('/') + 1);
}

/// The package's name in require(): its file's, but for one.
std::string module_name(std::string_view file_name, std::string_view ending) {
  const std::string name(file_name.substr(0, file_name.size() - ending.size()));
  return name == "vega-selection" ? "vega-selections" : name;
}

/// Debian's vega comes as one file per package, each of which would overwrite the global `vega` of
/// the others: they are loaded as CommonJS modules, and vega.js puts them together.
std::string vega_bundle() {
  constexpr std::string_view ending = ".min.js";
  std::string bundle(report_files::modules_js());
  for (const report_files::File& file : report_files::files())
    if (file.path.ends_with(ending))
      bundle += fmt::format("define(\"{}\", function (exports, module, require) {{{}\n}});\n",
                            module_name(stem_of(file), ending), file.text());
  return bundle + std::string(report_files::vega_js());
}

/// All scripts of the page, of which report.js alone does something when it is loaded.
std::string page_script() {
  constexpr std::string_view folder = "compare/report/page/";
  std::string script;
  for (const report_files::File& file : report_files::files())
    if (file.path == fmt::format("{}{}", folder, stem_of(file)) && file.path.ends_with(".js") &&
        stem_of(file) != "report.js")
      script += file.text();
  return script + std::string(report_files::report_js());
}

/// Returns the page with each {{name}} replaced by the text of that name, none of which is searched
/// for marks of its own.
std::string filled(std::string_view page, const std::map<std::string_view, std::string>& texts) {
  std::string result;
  for (std::size_t begin; (begin = page.find("{{")) != std::string_view::npos;) {
    const std::size_t end = page.find("}}", begin);
    result += page.substr(0, begin);
    result += texts.at(page.substr(begin + 2, end - begin - 2));
    page.remove_prefix(end + 2);
  }
  return result.append(page);
}

}  // namespace

void write_report(const fs::path& folder, const Study& study, std::span<const ResultRow> rows) {
  const std::string page = filled(report_files::report_html(),
                                  {{"title", html_escaped(study.title)},
                                   {"css", std::string(report_files::report_css())},
                                   {"vega", vega_bundle()},
                                   {"script", page_script()},
                                   {"data", inline_json(report_data(folder, study, rows))}});
  write_text(folder / "report.html", page);
}

}  // namespace pellucid::compare
