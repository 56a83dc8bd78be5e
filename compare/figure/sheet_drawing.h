// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "compare/figure/figure_sheet.h"

namespace pellucid::compare {

/// Returns the ruler of a font's families, as Pango measures them without hinting, so that a line
/// is as wide in every format.
TextRuler text_ruler(const std::string& font);

/// Returns the sheet as PDF: pictures in their own pixels, frames and lines as paths, texts in the
/// font's glyphs, which are embedded. `title` stands in the file's metadata. Throws InputError for
/// a sheet that is too large for the format.
std::string pdf_of(const FigureSheet& sheet, const std::string& font, const std::string& title);

/// Returns the sheet as SVG: likewise, but that texts are outlines, which look the same wherever
/// the font is missing.
std::string svg_of(const FigureSheet& sheet, const std::string& font);

/// Returns the sheet as a picture of so many dots per inch, on white. Throws likewise.
Image picture_of(const FigureSheet& sheet, const std::string& font, int dots_per_inch);

}  // namespace pellucid::compare
