// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/figure/figure_content.h"
#include "compare/figure/figure_sheet.h"

namespace pellucid::compare {

/// Lays a figure out `width` points wide, with labels of `font_size` points: a column for each
/// method, and for each scene its pictures, below them their crops, enlarged and joined to where
/// they are from, the maps, and the numbers. Throws InputError where a column would be too narrow.
FigureSheet lay_out(const FigureContent& content, double width, double font_size,
                    const TextRuler& ruler);

}  // namespace pellucid::compare
