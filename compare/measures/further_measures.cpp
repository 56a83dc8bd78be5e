// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/measures/further_measures.h"

namespace pellucid::compare {

std::span<const FurtherMeasure> further_measures() {
  static const FurtherMeasure table[] = {hull_measure(), depth_error_measure()};
  return table;
}

}  // namespace pellucid::compare
