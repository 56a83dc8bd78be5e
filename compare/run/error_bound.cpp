// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/run/error_bound.h"

#include <fmt/format.h>

#include <limits>

#include "core/error.h"

namespace pellucid::compare {
namespace {

std::optional<double> error_of(const ResultRow& row, const char* name, bool covered) {
  return row.metrics.linear.of(covered ? fmt::format("{}_covered", name) : std::string(name));
}

}  // namespace

bool ErrorBound::holds_for(const ResultRow& row) const {
  if (!row.error.empty()) return false;
  const std::optional<double> rmse = error_of(row, "rmse", covered);
  const std::optional<double> ssim = error_of(row, "ssim", covered);
  return (!max_rmse || (rmse && *rmse <= *max_rmse)) &&
         (!min_ssim || (ssim && *ssim >= *min_ssim)) &&
         (!max_bytes || known_bytes(row) <= *max_bytes);
}

std::uint64_t known_bytes(const ResultRow& row) {
  const bool unknown = !row.given.empty() && row.bytes.empty();
  return unknown ? std::numeric_limits<std::uint64_t>::max() : row.total_bytes();
}

void check_bound(const ErrorBound& bound) {
  if (!bound.max_rmse && !bound.min_ssim)
    throw InputError("tune: no bound; accepted: --max-rmse X or --min-ssim Y");
  if (bound.max_rmse && !(*bound.max_rmse >= 0))
    throw InputError("--max-rmse: accepted: a number of at least 0");
  if (bound.min_ssim && !(*bound.min_ssim >= -1 && *bound.min_ssim <= 1))
    throw InputError("--min-ssim: accepted: -1 … 1");
}

}  // namespace pellucid::compare
