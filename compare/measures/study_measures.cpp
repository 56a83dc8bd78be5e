// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/measures/study_measures.h"

namespace pellucid::compare {

std::span<const StudyMeasure> study_measures() {
  static const StudyMeasure table[] = {
      hull_measure(),      depth_error_measure(),   importance_error_measure(),
      bin_steps_measure(), context_share_measure(), longest_step_measure()};
  return table;
}

}  // namespace pellucid::compare
