// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/figure/figure_sheet.h"
#include "compare/figure/plots/plot.h"

namespace pellucid::compare {

/// Lays a plot out on a sheet `width` points wide, with labels of `font_size` points: its panels
/// side by side, as many as there is room for, and one legend below them all. A series has the same
/// colour and mark in every panel, by its label. Throws InputError where not even one panel fits.
FigureSheet lay_out_plot(const Plot& plot, double width, double font_size, const TextRuler& ruler);

}  // namespace pellucid::compare
