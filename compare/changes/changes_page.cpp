// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/changes/changes_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "compare/cells/cell.h"
#include "compare/changes/change_texts.h"
#include "compare/pictures/error_map.h"
#include "compare/pictures/image_file.h"
#include "compare/report/base64.h"
#include "compare/report/html_text.h"
#include "core/error.h"
#include "core/files/json_text.h"
#include "core/files/output_file.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view style =
    "body{font:15px/1.5 system-ui,sans-serif;margin:2rem auto;max-width:75rem;padding:0 1rem}"
    "h1,h2{font-weight:600}h2{font-size:1.1rem;margin:2rem 0 .3rem}"
    ".row{display:flex;gap:.6rem;flex-wrap:wrap}figure{margin:0;flex:1 1 18rem}"
    "img{width:100%;image-rendering:pixelated;border:1px solid #8886}"
    "figcaption{font-size:.85rem;opacity:.75}table{border-collapse:collapse}"
    "td,th{padding:.15rem .8rem .15rem 0;text-align:left}.worse{color:#b33}.better{color:#282}";

std::string figure(const std::string& png, std::string_view caption) {
  return fmt::format(
      "<figure><img alt=\"{0}\" src=\"data:image/png;base64,{1}\"><figcaption>{0}</figcaption>"
      "</figure>",
      caption, base64(png));
}

std::string map_of(const CellFiles& before, const CellFiles& after) {
  return encode_png(before.error_map(),
                    error_map(read_image(before.picture()), read_image(after.picture())),
                    form_of_error_map());
}

std::string pictures_html(const PictureChange& change, const ResultRow& row, const PastRun& before,
                          const PastRun& after) {
  if (!change.why_not.empty()) return "";
  const CellFiles a = CellFiles(before.folder, row).from(change.view);
  const CellFiles b = CellFiles(after.folder, row).from(change.view);
  return fmt::format("<div class=\"row\">{}{}{}</div>\n", figure(read_text(a.preview()), "before"),
                     figure(read_text(b.preview()), "after"),
                     figure(map_of(a, b), "difference, logarithmic from 0.001 to 1"));
}

std::string numbers_html(const std::vector<NumberChange>& numbers) {
  std::string rows;
  for (const NumberChange& n : numbers)
    rows += fmt::format("<tr{}><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                        !n.better   ? ""
                        : *n.better ? " class=\"better\""
                                    : " class=\"worse\"",
                        html_escaped(n.title), html_escaped(n.before), html_escaped(n.after));
  return rows.empty() ? ""
                      : "<table><tr><th>Number</th><th>Before</th><th>After</th></tr>\n" + rows +
                            "</table>\n";
}

std::string paragraph(const std::string& line) {
  return fmt::format("<p>{}</p>\n", html_escaped(line));
}

std::string cell_html(const CellChange& cell, const PastRun& before, const PastRun& after) {
  std::string html = fmt::format("<h2>{}</h2>\n", html_escaped(heading_line(cell)));
  for (const PictureChange& change : cell.pictures) html += paragraph(picture_line(change));
  for (const std::string& cause : cell.causes) html += paragraph(cause_line(cause));
  if (const ResultRow* row = find_row_of(before, cell.cell))
    for (const PictureChange& change : cell.pictures)
      html += pictures_html(change, *row, before, after);
  return html + numbers_html(cell.numbers);
}

double largest_of(const CellChange& cell) {
  double largest = 0;
  for (const PictureChange& p : cell.pictures) largest = std::max(largest, p.largest);
  return largest;
}

void make_folder(const fs::path& folder) {
  std::error_code code;
  fs::create_directories(folder, code);
  if (code)
    throw InputError(
        fmt::format("{}: cannot make the folder: {}", folder.string(), code.message()));
}

}  // namespace

void write_changes(const fs::path& folder, const RunChanges& changes, const PastRun& before,
                   const PastRun& after) {
  make_folder(folder);
  write_text(folder / "changes.json", json_text(to_json(changes), 1) + "\n");
  std::vector<CellChange> cells = changes.cells;
  std::ranges::stable_sort(cells, std::ranges::greater{}, largest_of);
  std::string page = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
      "<meta name=\"color-scheme\" content=\"light dark\"><title>{0}</title><style>{1}</style>"
      "</head><body><h1>{0}</h1>\n<p>{2} against {3}: {4}</p>\n",
      html_escaped("Two runs of " + before.study), style, html_escaped(after.folder.string()),
      html_escaped(before.folder.string()), lines_of(changes).back());
  for (const std::string& warning : changes.warnings) page += paragraph(warning);
  for (const CellChange& cell : cells)
    if (cell.kind != CellChange::Kind::same) page += cell_html(cell, before, after);
  write_text(folder / "changes.html", page + "</body></html>\n");
}

}  // namespace pellucid::compare
