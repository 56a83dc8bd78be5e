// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/figure/figure_request.h"

#include <fmt/format.h>

#include "core/error.h"
#include "core/options/names.h"
#include "core/options/parameters.h"

namespace pellucid::compare {

/// IEEE: "Size requirements for graphics" of the author center. Eurographics: the print area of the
/// author guidelines is 17.7 cm wide, and its two columns are 8.4 cm.
std::span<const FigureWidth> figure_widths() {
  static constexpr FigureWidth rows[] = {{"ieee-page", "both columns of IEEE", 181.9, true},
                                         {"ieee", "a column of IEEE", 88.9, false},
                                         {"eg-page", "both columns of Eurographics", 177, true},
                                         {"eg", "a column of Eurographics", 84, false}};
  return rows;
}

FigureWidth width_of_text(std::string_view text) {
  double millimetres = 0;
  if (!parse_number(text, millimetres)) return find_row("width", text, figure_widths());
  if (!(millimetres >= 20 && millimetres <= 1000))
    throw InputError(fmt::format("--width: {} mm; accepted: 20 … 1000", text));
  return {"", "", millimetres, millimetres >= 110};
}

}  // namespace pellucid::compare
