// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/figure/sheet_files.h"

#include <fmt/format.h>

#include <algorithm>

#include "compare/figure/sheet_drawing.h"
#include "compare/pictures/image_file.h"
#include "core/error.h"
#include "core/files/ending.h"
#include "core/files/output_file.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;

/// What each of the writers is given.
struct SheetFile {
  const fs::path& path;
  const FigureSheet& sheet;
  const FigureStyle& style;
  const std::string& title;
};

void write_pdf(const SheetFile& file) {
  write_text(file.path, pdf_of(file.sheet, file.style.font, file.title));
}

void write_svg(const SheetFile& file) {
  write_text(file.path, svg_of(file.sheet, file.style.font));
}

void write_png(const SheetFile& file) {
  PictureForm form = form_of_map("a figure of pictures, as they are shown");
  if (!file.title.empty()) form.text.emplace_back("Title", file.title);
  write_image(file.path, picture_of(file.sheet, file.style.font, file.style.dots_per_inch), form);
}

struct SheetFormat {
  std::string_view ending;
  void (*write)(const SheetFile&);
};

constexpr SheetFormat formats[] = {{".pdf", write_pdf}, {".svg", write_svg}, {".png", write_png}};

const SheetFormat& format_of(const fs::path& path, std::string_view further = "") {
  const auto* format = std::ranges::find(formats, small_ending(path), &SheetFormat::ending);
  if (format == std::end(formats))
    throw InputError(fmt::format("{}: ending '{}'; accepted: .pdf, .svg, .png{}{}", path.string(),
                                 path.extension().string(), further.empty() ? "" : ", ", further));
  return *format;
}

}  // namespace

void write_sheet(const fs::path& path, const FigureSheet& sheet, const FigureStyle& style,
                 const std::string& title) {
  format_of(path).write({path, sheet, style, title});
}

void require_sheet_ending(const fs::path& path, std::string_view further) {
  format_of(path, further);
}

}  // namespace pellucid::compare
