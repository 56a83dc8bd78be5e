// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/run/tune.h"

#include <algorithm>

#include "compare/cells/measure_cell.h"
#include "compare/methods/optimize_opacities.h"
#include "core/error.h"
#include "scene/files/scene_file.h"

namespace pellucid::compare {
namespace {

void check(const ErrorBound& bound) {
  if (!bound.max_rmse && !bound.min_ssim)
    throw InputError("tune: no bound; accepted: --max-rmse X or --min-ssim Y");
  if (bound.max_rmse && !(*bound.max_rmse >= 0))
    throw InputError("--max-rmse: accepted: a number of at least 0");
  if (bound.min_ssim && !(*bound.min_ssim >= -1 && *bound.min_ssim <= 1))
    throw InputError("--min-ssim: accepted: -1 … 1");
}

/// Also for equal costs the order does not depend on chance.
bool is_cheaper(Cost cost, const ResultRow& a, const ResultRow& b) {
  if (a.error.empty() != b.error.empty()) return a.error.empty();
  if (cost == Cost::seconds) return a.seconds.median < b.seconds.median;
  return std::pair(a.total_bytes(), a.seconds.median) <
         std::pair(b.total_bytes(), b.seconds.median);
}

class Tuning {
 public:
  explicit Tuning(const TuneRequest& request)
      : request_(request),
        scene_(scene::load_scene(request.scene, request.progress, request.view)) {
    if (request.opacities) optimize_opacities(*request.opacities, request.context, scene_);
  }

  TuneOutcome run() {
    progress(0, request_.reference);
    const Image reference = measured(request_.reference, 1).image;
    TuneOutcome outcome;
    for (std::size_t i = 0; i < request_.candidates.size(); ++i) {
      progress(i + 1, request_.candidates[i]);
      outcome.rows.push_back(try_candidate(request_.candidates[i], reference));
      if (request_.on_row) request_.on_row(outcome.rows.back());
    }
    report(request_.progress, 1, "tuned");
    std::stable_sort(
        outcome.rows.begin(), outcome.rows.end(),
        [&](const ResultRow& a, const ResultRow& b) { return is_cheaper(request_.cost, a, b); });
    for (const ResultRow& row : outcome.rows)
      outcome.within_bound.push_back(request_.bound.holds_for(row));
    return outcome;
  }

 private:
  void progress(std::size_t done, const MethodCall& next) const {
    report(request_.progress, double(done) / double(request_.candidates.size() + 1), next.text());
  }

  Cell cell(const MethodCall& call) const {
    return {request_.scene, scene_name(request_.scene), call};
  }

  CellMeasurement measured(const MethodCall& call, int repeats) const {
    return measure_cell(cell(call), scene_, repeats, request_.context);
  }

  ResultRow try_candidate(const MethodCall& call, const Image& reference) const {
    try {
      CellMeasurement measurement = measured(call, request_.repeats);
      measurement.row.metrics = compare_images(reference, measurement.image);
      return std::move(measurement.row);
    } catch (const std::exception& error) {
      ResultRow row = identity_row(cell(call));
      row.error = error.what();
      return row;
    }
  }

  const TuneRequest& request_;
  scene::Scene scene_;
};

}  // namespace

bool ErrorBound::holds_for(const ResultRow& row) const {
  const std::optional<double> rmse = row.metrics.linear.of("rmse");
  const std::optional<double> ssim = row.metrics.linear.of("ssim");
  return row.error.empty() && (!max_rmse || (rmse && *rmse <= *max_rmse)) &&
         (!min_ssim || (ssim && *ssim >= *min_ssim)) &&
         (!max_bytes || row.total_bytes() <= *max_bytes);
}

const ResultRow* TuneOutcome::best() const {
  const auto found = std::find(within_bound.begin(), within_bound.end(), true);
  return found == within_bound.end() ? nullptr : &rows[std::size_t(found - within_bound.begin())];
}

TuneOutcome tune(const TuneRequest& request) {
  check(request.bound);
  return Tuning(request).run();
}

}  // namespace pellucid::compare
