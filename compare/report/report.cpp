// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/report/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "compare/report/html_text.h"
#include "compare/report/page_texts.h"
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
  constexpr std::string_view folder = "compare/report/page/", vega = "compare/report/page/vega/";
  std::string script;
  for (const report_files::File& file : report_files::files())
    if (file.path.starts_with(folder) && !file.path.starts_with(vega) &&
        file.path.ends_with(".js") && stem_of(file) != "report.js")
      script += file.text();
  return script + std::string(report_files::report_js());
}

/// Elements that no browser runs; the page's script reads them when it needs them.
std::string text_elements(const PageTexts& texts) {
  std::string elements;
  for (const auto& [key, text] : texts)
    elements += fmt::format("<script type=\"text/plain\" id=\"{}\">{}</script>\n", key, text);
  return elements;
}

/// The files beside a folder's page, which it may load: `file:` where it was opened as a file.
constexpr const char* files_beside = " 'self' file:";

std::string page_of(const Study& study, const nlohmann::json& data, const PageTexts& texts = {}) {
  return filled(report_files::report_html(),
                {{"title", html_escaped(study.title)},
                 {"css", std::string(report_files::report_css())},
                 {"vega", vega_bundle()},
                 {"script", page_script()},
                 {"data", inline_json(data)},
                 {"beside", data["pixels"]["in_folder"] ? files_beside : ""},
                 {"texts", text_elements(texts)}});
}

/// What an earlier report of a folder has left, which the page that is there now does not load.
void remove_other_texts(const fs::path& folder, const std::set<std::string>& loaded) {
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder / "report", ignored))
    if (entry.path().extension() == ".js" && !loaded.contains(entry.path().stem().string()))
      fs::remove(entry.path(), ignored);
  fs::remove(folder / "report", ignored);  // where it is empty
}

/// A ReportWriter makes the page of a study's cells in the one form or the other.
class ReportWriter {
 public:
  ReportWriter(const fs::path& folder, const Study& study, std::span<const ResultRow> rows,
               const ReportForm& form)
      : folder_(folder),
        study_(study),
        rows_(rows),
        form_(form),
        cells_(report_cells(folder, study, rows)) {}

  /// Whoever is killed leaves the page of before, or the new one, each with all its texts.
  void write() const { remove_other_texts(folder_, write_in_form()); }

 private:
  /// Returns the texts that the page loads from beside it.
  std::set<std::string> write_in_form() const {
    if (form_.kind == ReportForm::Kind::folder) return write_folder();
    nlohmann::json data = data_of(false);
    const std::size_t least = page_of(study_, data).size();
    if (least > form_.most_bytes && form_.kind == ReportForm::Kind::automatic)
      return write_folder();
    write_file(std::move(data), form_.most_bytes - std::min(least, form_.most_bytes));
    return {};
  }

  nlohmann::json data_of(bool in_folder) const {
    nlohmann::json data = report_data(folder_, study_, rows_, cells_, in_folder);
    data["command"] = form_.command;
    data["pixels"] = {{"in_folder", in_folder}, {"mantissa_bits", in_folder ? 23 : 0}};
    return data;
  }

  void write_page(const nlohmann::json& data, const PageTexts& texts = {}) const {
    write_text(folder_ / "report.html", page_of(study_, data, texts));
  }

  void write_file(nlohmann::json data, std::size_t most_bytes) const {
    for (const int bits : {23, 15})
      if (const auto texts = pixel_texts(cells_, bits, most_bytes)) {
        data["pixels"]["mantissa_bits"] = bits;
        return write_page(data, *texts);
      }
    write_page(data);
  }

  /// A page that was opened from a file may load scripts from beside it, and nothing else.
  std::set<std::string> write_folder() const {
    fs::create_directories(folder_ / "report");
    std::set<std::string> keys;
    for_each_text(cells_, [&](const std::string& key, const std::string& text) {
      keys.insert(key);
      write_text(folder_ / "report" / (key + ".js"),
                 fmt::format("pellucidText(\"{}\", \"{}\");\n", key, text));
    });
    write_page(data_of(true));
    return keys;
  }

  const fs::path& folder_;
  const Study& study_;
  std::span<const ResultRow> rows_;
  const ReportForm& form_;
  std::vector<ReportCell> cells_;
};

}  // namespace

void write_report(const fs::path& folder, const Study& study, std::span<const ResultRow> rows,
                  const ReportForm& form) {
  ReportWriter(folder, study, rows, form).write();
}

}  // namespace pellucid::compare
