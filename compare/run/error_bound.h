// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "compare/results/result_row.h"

namespace pellucid::compare {

/// An ErrorBound is what a picture has to reach; at least one of the first two is set.
struct ErrorBound {
  std::optional<double> max_rmse;
  std::optional<double> min_ssim;  // a picture without SSIM (a side below 11 pixels) fails it
  std::optional<std::uint64_t> max_bytes;  // beyond the scene and the picture
  bool covered = false;  // RMSE and SSIM are those over the pixels with a layer in the reference

  bool holds_for(const ResultRow& row) const;
};

/// Returns the bytes that a row's method needs; the most there are where a program of somebody
/// else's does not tell.
std::uint64_t known_bytes(const ResultRow& row);

/// Throws InputError for a bound that bounds no error, a negative RMSE, and an SSIM outside of
/// [-1, 1].
void check_bound(const ErrorBound& bound);

}  // namespace pellucid::compare
