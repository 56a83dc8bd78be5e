// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/figure/plots/write_plot.h"

#include <fmt/format.h>

#include "compare/figure/plots/plot_layout.h"
#include "compare/figure/sheet_drawing.h"
#include "compare/figure/sheet_files.h"
#include "core/files/ending.h"
#include "core/files/output_file.h"

namespace pellucid::compare {

WrittenFigure write_plot(const std::filesystem::path& path, const PastRun& run,
                         const PlotRequest& request, const FigureStyle& style) {
  constexpr std::string_view table = ".csv";
  const bool is_table = small_ending(path) == table;
  if (!is_table) require_sheet_ending(path, table);
  const Plot plot = read_plot(run, request);
  if (is_table) {
    write_text(path, csv_of(plot));
    return {{path}, 0, 0, {}, {}};
  }
  const FigureSheet sheet = lay_out_plot(plot, style.width.millimetres / 25.4 * 72, style.font_size,
                                         text_ruler(style.font));
  const std::string title = run.title.empty() ? run.study : run.title;
  write_sheet(path, sheet, style, fmt::format("{}: {} over {}", title, plot.y.title, plot.x.title));
  return {{path}, sheet.width, sheet.height, {}, {}};
}

}  // namespace pellucid::compare
