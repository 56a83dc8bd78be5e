// SPDX-License-Identifier: GPL-3.0-or-later
// A picture's error split into parts of the stages that made it, so that the parts add up.
//
// P(S) is the picture with the stages S refined, e = P(∅) - P(N) the whole error. Squares of norms
// do not add up; projections onto e do: the share of a difference picture d is <d, e> / <e, e>.
// Stage i is refined first, before all others, and last, after all others:
//
//     first_i = P(∅) - P({i}),   last_i = P(N \ {i}) - P(N),   share_i = <(first_i + last_i) / 2,
//     e> / <e, e>
//
// Where the stages act in pairs at most, P(S) = P(∅) + Σ a_i + Σ b_ij, this is each stage's Shapley
// value (Shapley 1953, A value for n-person games), a_i + Σ b_ij / 2, and the shares add up to 1:
// 2 n + 2 pictures do for 2^n. What three stages or more do together is left over: the interaction
// 1 - Σ share_i. |first_i - last_i| is what the stage shares with others.
//
// A stage may need another one refined before it. Then first_i is taken upon that one, and last_i
// without the stages that need i (a chain's parts add up to those of the chain as one stage).
#pragma once

#include <map>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "compare/results/error_budget.h"
#include "compare/timing/timing_rule.h"
#include "core/raster.h"

namespace pellucid::compare {

/// A StageSet has bit i where stage i is refined.
using StageSet = unsigned;

/// A StageOrder names, for each stage, the stage that has to be refined before it, if any.
using StageOrder = std::vector<std::optional<std::size_t>>;

/// A DrawnPicture is a picture with some stages refined, and the seconds that it takes: to draw it,
/// and to make its scene. Times are needed of sets_to_time() alone.
struct DrawnPicture {
  Image image;
  Spread drawing;
  std::size_t scene = 0;  // which one of all scenes: making it costs pictures of one scene the same
  Spread making;

  double seconds() const { return drawing.median + making.median; }
};

/// Returns the sets of refined stages whose pictures split_error() needs.
std::set<StageSet> sets_to_draw(const StageOrder& order);

/// Returns the sets of refined stages whose pictures' times split_error() needs, 0 among them.
std::set<StageSet> sets_to_time(const StageOrder& order);

/// A SplitError is the budget, with a line for each stage without its texts, and how far each
/// stage's mean difference picture differs from none, per pixel: the largest of red, green, blue.
struct SplitError {
  ErrorBudget budget;
  std::vector<Raster<double>> amounts;
};

/// Splits the error of the picture without refined stages. All pictures of sets_to_draw() are there
/// and have one size. Where the whole error is 0, so is every share, and the interaction.
SplitError split_error(const StageOrder& order, const std::map<StageSet, DrawnPicture>& pictures);

}  // namespace pellucid::compare
