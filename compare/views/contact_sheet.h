// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "compare/figure/figure_sheet.h"
#include "compare/views/rank_views.h"

namespace pellucid::compare {

/// Returns the views' pictures in a grid, the best first, each with its rank, its side and what it
/// shows below it. All pictures have one size, and there is at least one.
FigureSheet contact_sheet(const std::vector<RankedView>& views, const std::vector<Image>& pictures,
                          const TextRuler& ruler);

}  // namespace pellucid::compare
