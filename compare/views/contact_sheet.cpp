// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/views/contact_sheet.h"

#include <fmt/format.h>

#include <cmath>

#include "compare/figure/fitted_text.h"

namespace pellucid::compare {
namespace {

// In points.
constexpr double cell_width = 150, gap = 8, font = 8, line_height = 1.25;

std::vector<std::string> lines_of(const RankedView& view, std::size_t rank) {
  const ViewScore& score = view.score;
  std::vector<std::string> lines{
      fmt::format("{}: azimuth {:.0f}°, elevation {:.0f}°", rank, view.azimuth, view.elevation),
      fmt::format("covered {:.0f} %, layers {:.1f}, hidden {:.0f} %", 100 * score.covered,
                  score.layers, 100 * score.hidden)};
  if (score.importance > 0)
    lines.push_back(fmt::format("importance seen {:.3f}", score.importance));
  return lines;
}

}  // namespace

FigureSheet contact_sheet(const std::vector<RankedView>& views, const std::vector<Image>& pictures,
                          const TextRuler& ruler) {
  const auto columns = std::size_t(std::ceil(std::sqrt(double(views.size()))));
  const double height = cell_width * pictures.front().height / pictures.front().width;
  const double text = font * line_height * double(lines_of(views.front(), 1).size());
  FigureSheet sheet;
  for (std::size_t i = 0; i < views.size(); ++i) {
    const SheetBox box{gap + double(i % columns) * (cell_width + gap),
                       gap + double(i / columns) * (height + text + gap), cell_width, height};
    sheet.pictures.push_back({box, pictures[i]});
    double y = box.bottom() + font;
    for (const std::string& line : lines_of(views[i], i + 1)) {
      sheet.texts.push_back({{{fitted(line, font, cell_width, ruler)}}, font, {box.middle(), y}});
      y += font * line_height;
    }
    sheet.width = std::max(sheet.width, box.right() + gap);
    sheet.height = std::max(sheet.height, box.bottom() + text + gap);
  }
  return sheet;
}

}  // namespace pellucid::compare
