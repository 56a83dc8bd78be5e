// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "compare/results/columns.h"

namespace pellucid::compare {

/// A Claim is what a study's source found: an order of its pictures by one number, to be held
/// against what is measured here.
struct Claim {
  std::string text;    // for people: "Fourier errs least"
  const Column* by{};  // a column in which one way is better
  /// Calls as MethodCall::text() has them, the best first; of those in one group no order is
  /// claimed.
  std::vector<std::vector<std::string>> order;
};

/// A claim on one scene, or on the mean over all scenes.
struct ClaimCheck {
  std::string scene;                                   // "mean" where it is of all scenes
  std::vector<std::pair<std::string, double>> values;  // by call, in the claimed order
  /// Pairs of calls whose order is the other one here, the claimed better one first.
  std::vector<std::pair<std::string, std::string>> against;
};

/// A check for each scene of which all the claim's rows are there, in the order of `scenes`; after
/// them, for more than one scene, that of the mean over those scenes.
std::vector<ClaimCheck> check_claim(const Claim& claim, std::span<const std::string> scenes,
                                    std::span<const ResultRow> rows);

}  // namespace pellucid::compare
