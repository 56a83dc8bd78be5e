// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "compare/results/result_row.h"
#include "compare/run/error_bound.h"
#include "compare/study/study.h"
#include "scene/files/view_request.h"

namespace pellucid::compare {

/// A Cost says by what candidates are compared: the median time in seconds, or the bytes beyond the
/// scene and the picture, of which there is no doubt: who needs as few is tied, whatever the time.
enum class Cost { seconds, bytes };

/// A TuneEstimate is what tuning will do, told before it begins.
struct TuneEstimate {
  std::size_t candidates = 0;  // that compete
  double seconds = 0;          // all of it, as far as small pictures tell
};

/// A TuneRequest asks for the cheapest candidate on a scene within a bound.
struct TuneRequest {
  std::filesystem::path scene;
  scene::ViewRequest view = {};  // goes before the scene file's
  MethodCall reference;
  std::vector<MethodCall> candidates;
  ErrorBound bound;
  Cost cost = Cost::seconds;
  int repeats =
      30;  // timed pictures of each contender, at most; fewer than five tell no times apart
  std::optional<MethodCall> opacities = std::nullopt;  // see Study
  scene::RenderContext context;
  Progress progress;
  std::function<void(const ResultRow&)> on_row;  // called when a candidate's error is known
  /// After so long no call's picture is begun, but for the reference's.
  std::optional<double> max_seconds = std::nullopt;
  std::function<void(const TuneEstimate&)> on_estimate = nullptr;
};

/// A LeftOut is a candidate that did not compete to the end, and why, in words.
struct LeftOut {
  std::string call, why;
  bool undecided = false;  // it was not drawn in time, and may be within the bound and cheaper
};

/// A TuneOutcome is what was measured of all candidates.
struct TuneOutcome {
  std::vector<ResultRow> rows;       // of those drawn in full, the cheapest first; failed ones last
  std::vector<bool> within_bound{};  // row by row
  std::vector<bool> tied{};          // row by row: its cost is not told from the cheapest's
  std::vector<LeftOut> left_out{};
  std::optional<std::size_t> cheapest{};  // a row; nothing where none is within the bound

  /// Returns the cheapest within the bound; null when none is.
  const ResultRow* best() const { return cheapest ? &rows[*cheapest] : nullptr; }
};

/// Finds the cheapest candidate within the bound, by rounds that leave out more and more:
///
/// 1. Who draws only what the reference draws (an isosurface's method where there is none), and who
///    chooses opacities itself, whose picture is meant to differ, does not compete.
/// 2. All draw a picture of a quarter of the width and height, as far as three tenths of the time
///    suffice. It tells the duration, and the order of what follows, the fastest first.
/// 3. Each draws the whole picture, once. Its error is that against the reference's. Who took
///    longer for the small picture than the best yet within the bound for the whole is not drawn in
///    full; who is beyond the bound, or took more than twice the time of the fastest, is not timed
///    further: either by the least of five times in turn with it, unless it is eight times as much.
///    By bytes none is timed. When seven tenths of the time are over none is begun any
///    more; the reference's own call has been drawn before. Who was not is undecided.
/// 4. The contenders that are left are timed in turn, at most `repeats` times. Who is slower than
///    the fastest by intervals that do not overlap is out, by these times alone: what came before
///    was taken at other moments. It ends when one is left, when the intervals of all are within a
///    hundredth of their medians, or when the time is over: see fastest_of().
///
/// If several are left they are tied, and the cheapest is of them the one with the fewest bytes,
/// then of the least error, then the first of the candidates: none of this is chance.
///
/// A candidate that fails becomes a row with its error. Throws InputError for a bound that bounds
/// no error, a negative RMSE, an SSIM outside of [-1, 1], a wrong scene, and where no candidate is
/// left to compete; and what the reference throws.
TuneOutcome tune(const TuneRequest& request);

}  // namespace pellucid::compare
