// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/site/results_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "compare/methods/methods.h"
#include "compare/pack/pack_run.h"
#include "compare/report/html_text.h"
#include "compare/study/study.h"
#include "core/error.h"
#include "core/files/output_file.h"

namespace pellucid::view {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view report_name = "report.html";

constexpr std::array<std::pair<std::string_view, std::string_view>, 5> types{
    {{".html", "text/html; charset=utf-8"},
     {".js", "text/javascript; charset=utf-8"},
     {".png", "image/png"},
     {".json", "application/json"},
     {".csv", "text/csv; charset=utf-8"}}};

std::string type_of(const fs::path& file) {
  const auto known = std::ranges::find(types, file.extension().string(),
                                       [](const auto& row) { return row.first; });
  return std::string(known == types.end() ? "application/octet-stream" : known->second);
}

/// Whether both are resolved, and the file is below the folder.
bool is_below(const fs::path& file, const fs::path& folder) {
  return std::ranges::mismatch(folder, file).in1 == folder.end();
}

std::string links_to(std::span<const SceneFile> scenes) {
  std::string links = "<nav aria-label=\"Live\"><div><span>Turn</span>";
  for (std::size_t i = 0; i < scenes.size(); ++i)
    links += fmt::format("<a href=\"../scene/{}/\">{}</a>", i,
                         compare::html_escaped(scenes[i].file.stem().string()));
  return links + "</div></nav>\n";
}

/// The report as it stands in its file, with links below its head.
std::string with_links(std::string page, std::span<const SceneFile> scenes) {
  constexpr std::string_view before = "<main id=\"main\">";
  if (const std::size_t at = page.find(before); at != std::string::npos && !scenes.empty())
    page.insert(at, links_to(scenes));
  return page;
}

std::vector<SceneFile> scenes_of(const fs::path& folder) {
  std::vector<SceneFile> scenes;
  try {
    const compare::Study study =
        compare::load_study(compare::study_of_run(folder), compare::callable_methods());
    for (const fs::path& file : study.scenes) scenes.push_back({file, false});
  } catch (const InputError&) {  // the study has moved: its report is still there
  }
  return scenes;
}

}  // namespace

SiteContent results_content(const fs::path& folder) {
  require_file(folder / report_name);
  return {scenes_of(folder), fs::canonical(folder)};
}

Answer results_file(const fs::path& folder, std::string_view path,
                    std::span<const SceneFile> scenes) {
  std::error_code error;
  const fs::path file = fs::canonical(folder / fs::path(path), error);
  if (error || !is_below(file, folder) || !fs::is_regular_file(file, error))
    return failure(404, "the results have no such file");
  std::string text = read_text(file);
  if (path == report_name) text = with_links(std::move(text), scenes);
  return {.status = 200, .type = type_of(file), .body = std::move(text)};
}

}  // namespace pellucid::view
