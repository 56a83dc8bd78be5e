// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/figure/figure_latex.h"

#include <fmt/format.h>

#include "compare/report/tables.h"

namespace pellucid::compare {
namespace {

std::string latex_run(const TextRun& run) {
  if (run.is_raised) return fmt::format("$^{{{}}}$", run.text);
  std::string text = latex_escaped(run.text);
  // Old engines and some fonts lack the character.
  if (const std::size_t dot = text.find("·10"); run.text.ends_with("·10"))
    text.replace(dot, std::string_view("·").size(), "$\\cdot$");
  return run.is_bold ? fmt::format("\\textbf{{{}}}", text) : text;
}

}  // namespace

std::string latex_runs(const std::vector<TextRun>& runs) {
  std::string words;
  for (const TextRun& run : runs) words += latex_run(run);
  return words;
}

namespace {

/// The middle of the text's baseline lies at the place, which LaTeX counts from the bottom.
std::string latex_text(const SheetText& text, double sheet_height) {
  const std::string words = latex_runs(text.runs);
  std::string box =
      fmt::format("\\makebox(0,0)[b]{{\\fontsize{{{0:.2f}}}{{{1:.2f}}}\\selectfont\\smash{{{2}}}}}",
                  text.size, 1.2 * text.size, words);
  if (text.is_turned) box = fmt::format("\\rotatebox{{90}}{{{}}}", box);
  return fmt::format("    \\put({:.2f},{:.2f}){{{}}}%\n", text.at.x, sheet_height - text.at.y, box);
}

}  // namespace

std::string latex_figure(const FigureSheet& sheet, const std::string& pictures,
                         const FigureWidth& width, const FigureCaption& caption) {
  const std::string_view environment = width.is_page ? "figure*" : "figure";
  std::string text = fmt::format(
      "{0}% Needs \\usepackage{{graphicx}}; {1} lies beside this file.\n"
      "\\begin{{{2}}}[t]\n  \\centering\n"
      "  \\setlength{{\\unitlength}}{{\\dimexpr\\linewidth*100/{3:.0f}\\relax}}%\n"
      "  \\begin{{picture}}({4:.2f},{5:.2f})%\n"
      "    \\put(0,0){{\\includegraphics[width={4:.2f}\\unitlength]{{{1}}}}}%\n",
      latex_comment(caption.command) + caption.warnings, pictures, environment, 100 * sheet.width,
      sheet.width, sheet.height);
  for (const SheetText& line : sheet.texts) text += latex_text(line, sheet.height);
  return text +
         fmt::format("  \\end{{picture}}\n  \\caption{{{}}}\n  \\label{{fig:{}}}\n\\end{{{}}}\n",
                     latex_escaped(caption.text), caption.label, environment);
}

}  // namespace pellucid::compare
