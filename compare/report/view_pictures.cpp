// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/report/view_pictures.h"

#include <nlohmann/json.hpp>

#include "compare/pictures/image_file.h"
#include "compare/report/base64.h"
#include "compare/report/url_text.h"
#include "compare/results/measure_columns.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;

constexpr int widest = 96;  // pixels

/// Means over squares of pixels; what is left over at the right and the bottom is left out.
Image reduced(const Image& image) {
  const int side = (image.width + widest - 1) / widest;
  Image small(image.width / side, std::max(1, image.height / side));
  for (int y = 0; y < small.height; ++y)
    for (int x = 0; x < small.width; ++x) {
      Rgba sum(0);
      const int rows = std::min(side, image.height - y * side);
      for (int j = 0; j < rows; ++j)
        for (int i = 0; i < side; ++i) sum += image.at(x * side + i, y * side + j);
      small.at(x, y) = sum / float(side * rows);
    }
  return small;
}

std::string small_source(const fs::path& png) {
  return "data:image/png;base64," + base64(encode_png(png, reduced(read_image(png)), {}));
}

}  // namespace

std::size_t count_view_pictures(std::span<const ReportCell> cells) {
  std::size_t count = 0;
  for (const ReportCell& cell : cells)
    if (const int views = views_of(std::span(cell.row, 1)); cell.is_done() && views > 1)
      count += std::size_t(views);
  return count;
}

nlohmann::json view_pictures(const ReportCell& cell, const fs::path& folder, bool in_folder) {
  nlohmann::json sources = nlohmann::json::array();
  const int views = views_of(std::span(cell.row, 1));
  for (int view = 0; view < views && views > 1; ++view) {
    const CellFiles files = cell.files.from(std::size_t(view));
    const fs::path png = cell.row->reference ? files.preview() : files.error_map();
    if (!fs::exists(png))
      sources.push_back(nullptr);
    else
      sources.push_back(in_folder ? url_of(png.lexically_relative(folder)) : small_source(png));
  }
  return sources;
}

}  // namespace pellucid::compare
