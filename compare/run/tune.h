// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "compare/results/result_row.h"
#include "compare/study/study.h"
#include "scene/files/view_request.h"

namespace pellucid::compare {

/// An ErrorBound is what a picture has to reach; at least one of the first two is set.
struct ErrorBound {
  std::optional<double> max_rmse;
  std::optional<double> min_ssim;  // a picture without SSIM (a side below 11 pixels) fails it
  std::optional<std::uint64_t> max_bytes;  // beyond the scene and the picture

  bool holds_for(const ResultRow& row) const;
};

/// A Cost says by what candidates are compared: the median time in seconds, or the bytes beyond the
/// scene and the picture.
enum class Cost { seconds, bytes };

/// A TuneRequest asks for the cheapest candidate on a scene within a bound.
struct TuneRequest {
  std::filesystem::path scene;
  scene::ViewRequest view = {};  // goes before the scene file's
  MethodCall reference;
  std::vector<MethodCall> candidates;
  ErrorBound bound;
  Cost cost = Cost::seconds;  // median time, or bytes beyond the scene and the picture
  int repeats = 3;            // timed renderings of each candidate
  std::optional<MethodCall> opacities = std::nullopt;  // see Study
  scene::RenderContext context;
  Progress progress;
  std::function<void(const ResultRow&)> on_row;  // called when a candidate is measured
};

/// A TuneOutcome is what was measured of all candidates.
struct TuneOutcome {
  std::vector<ResultRow> rows;       // of the candidates, the cheapest first; failed ones last
  const ResultRow* best() const;     // the cheapest within the bound; null when none is
  std::vector<bool> within_bound{};  // row by row
};

/// Renders the scene by the reference and by every candidate, and finds the cheapest within the
/// bound. A candidate that fails becomes a row with its error. Throws InputError for a bound that
/// bounds no error, a negative RMSE, an SSIM outside of [-1, 1] and a wrong scene; and what the
/// reference throws.
TuneOutcome tune(const TuneRequest& request);

}  // namespace pellucid::compare
