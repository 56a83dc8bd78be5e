// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "integrators/lines/integrate_lines.h"

namespace pellucid::integrators {

/// Runs `run`, which knows positive durations alone, as the request asks: a negative duration in
/// the reversed field; `both` in both directions, whose lines are joined at their seeds, the
/// backward way first.
IntegratedLines run_in_directions(const LineRequest& request,
                                  const std::function<IntegratedLines(const LineRequest&)>& run);

}  // namespace pellucid::integrators
