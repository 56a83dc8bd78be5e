// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/figure/write_figure.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

#include "compare/figure/figure_content.h"
#include "compare/figure/figure_latex.h"
#include "compare/figure/figure_layout.h"
#include "compare/figure/figure_table.h"
#include "compare/figure/sheet_drawing.h"
#include "compare/figure/sheet_files.h"
#include "compare/report/tables.h"
#include "compare/results/measure_columns.h"
#include "core/error.h"
#include "core/files/ending.h"
#include "core/files/output_file.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view latex_ending = ".tex";

/// The pictures first: a text that names them is not there without them.
std::vector<fs::path> write_latex(const fs::path& path, FigureSheet sheet, const FigureStyle& style,
                                  const FigureCaption& caption) {
  const fs::path beside = fs::path(path).replace_extension("").string() + "-pictures.pdf";
  const std::string text = latex_figure(sheet, beside.filename().string(), style.width, caption);
  sheet.texts.clear();
  write_sheet(beside, sheet, style, caption.text);
  write_text(path, text);
  return {path, beside};
}

/// \includegraphics takes some characters of a name for commands, and so does \label.
void check_name(const fs::path& path) {
  const auto is_plain = [](unsigned char c) {
    return std::isalnum(c) || std::string_view("-_+.").find(char(c)) != std::string_view::npos;
  };
  const std::string stem = path.stem().string();
  if (!std::ranges::all_of(stem, is_plain))
    throw InputError(fmt::format(
        "{}: LaTeX does not take such a name for a file or a label; accepted: letters, digits and "
        "-_+.",
        path.string()));
}

std::string title_of(const PastRun& run) { return run.title.empty() ? run.study : run.title; }

std::string reference_name(const PastRun& run) {
  const auto row = std::ranges::find(run.rows, true, &ResultRow::reference);
  return row == run.rows.end() ? "the reference" : row->call();
}

/// The marks of the numbers, as far as there are any.
std::string numbers_caption(const PastRun& run, const FigureContent& content) {
  std::string text =
      fmt::format(" Errors are against {}; the best numbers are bold", reference_name(run));
  const auto is_tie = [](const TextRun& one) { return one.text == "*"; };
  for (const FigureStrip& strip : content.strips)
    for (const FigureNumbers& numbers : strip.numbers)
      for (const auto* lines : {&numbers.errors, &numbers.costs})
        for (const std::vector<TextRun>& line : *lines)
          if (std::ranges::any_of(line, is_tie)) return text + ", * those tied with them.";
  return text + '.';
}

/// What a reader has to know of the pictures and of their numbers.
std::string caption_of(const PastRun& run, const FigureContent& content,
                       const FigureRequest& request) {
  std::vector<std::string> columns, strips;
  for (const FigureHeading& heading : content.headings)
    columns.push_back(heading.parameters.empty()
                          ? heading.title
                          : fmt::format("{} ({})", heading.title, heading.parameters));
  for (const FigureStrip& strip : content.strips) strips.push_back(strip.label);
  std::string text =
      fmt::format("{}. From left to right: {}.", title_of(run), fmt::join(columns, "; "));
  if (strips.size() > 1) text += fmt::format(" From top to bottom: {}.", fmt::join(strips, "; "));
  if (!request.numbers.empty()) text += numbers_caption(run, content);
  if (const int views = views_of(run.rows); views > 1)
    text += fmt::format(" Pictures are of view 1 of {}{}.", views,
                        request.numbers.empty() ? "" : ", numbers means over the views");
  return text;
}

}  // namespace

WrittenFigure write_figure(const fs::path& path, const PastRun& run, const FigureRequest& request,
                           const FigureStyle& style, const std::string& command) {
  const bool is_latex = small_ending(path) == latex_ending;
  is_latex ? check_name(path) : require_sheet_ending(path, latex_ending);
  const FigureContent content = read_figure(run, request);
  const FigureSheet sheet = lay_out(content, style.width.millimetres / 25.4 * 72, style.font_size,
                                    text_ruler(style.font));
  WrittenFigure written{{path}, sheet.width, sheet.height, find_figure_rows(run, request), {}};
  const FigureCaption caption{caption_of(run, content, request), path.stem().string(), command,
                              latex_warnings(rows_in(written.rows))};
  if (is_latex)
    written.files = write_latex(path, sheet, style, caption);
  else
    write_sheet(path, sheet, style, caption.text);
  for (const FigureStrip& strip : content.strips) written.crops.push_back(strip.crops);
  return written;
}

WrittenFigure write_figure_table(const fs::path& path, const PastRun& run,
                                 const FigureRequest& request, const FigureStyle& style,
                                 const std::string& command) {
  if (small_ending(path) != latex_ending)
    throw InputError(fmt::format("{}: ending '{}'; accepted for a table: {}", path.string(),
                                 path.extension().string(), latex_ending));
  check_name(path);
  if (request.numbers.empty()) throw InputError("--numbers: none; accepted for a table: some");
  WrittenFigure written{{path}, 0, 0, find_figure_rows(run, request), {}};
  const std::vector<ResultRow> rows = rows_in(written.rows);
  std::string text = fmt::format(
      "{}. Errors are against {}. Bold is the best; a star marks what 95 % intervals do "
      "not tell from it.",
      title_of(run), reference_name(run));
  if (const int views = views_of(rows); views > 1)
    text += fmt::format(" Numbers are means over {} views.", views);
  write_text(path, latex_figure_table(written.rows, request, style.width,
                                      {text, path.stem().string(), command, latex_warnings(rows)}));
  return written;
}

}  // namespace pellucid::compare
