// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "compare/results/result_row.h"

namespace pellucid::compare {

/// Returns a row whose SSIM is what its RMSE leaves of 1.
inline ResultRow row(const std::string& scene, const std::string& method, double rmse) {
  ResultRow row;
  row.scene = scene;
  row.method = method;
  row.metrics.linear.of("rmse") = rmse;
  row.metrics.linear.of("ssim") = 1 - rmse;
  return row;
}

}  // namespace pellucid::compare
