// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "compare/results/columns.h"

namespace pellucid::compare {

/// A ClaimedNumber is what a claim is about: a column, a measure that only some methods have, or a
/// stage's share of the error.
struct ClaimedNumber {
  const Column* column = nullptr;  // null: the measure, or the stage
  std::string measure;             // by its name: "outside_hull"
  Better better = Better::lower;
  std::string stage = {};  // of the error's budget: "samples"; empty: the column or the measure

  /// Returns the row's number; nothing where it has none.
  std::optional<double> of(const ResultRow& row) const;
  /// Returns where the row's number lies: a number without noise is its own interval; a time has
  /// none where it was measured less than five times, or where only one of it is kept.
  std::optional<Interval> interval_of(const ResultRow& row) const;
  /// Returns the number in few digits, in the unit for people.
  std::string text(double value) const;
  /// Returns "Time [ms]"; of a measure its name; "share of 'samples'".
  std::string heading() const;
};

/// A Claim is what a study's source found of its pictures by one number, to be held against what is
/// measured here: an order, a bound, or that numbers are the same.
struct Claim {
  std::string text;  // for people: "Fourier errs least"
  ClaimedNumber by;
  /// Calls as MethodCall::text() has them, the best first; of those in one group no order is
  /// claimed. A bound is claimed of the only group's calls.
  std::vector<std::vector<std::string>> order;
  /// Each call is better than those of later groups by this factor at least.
  double factor = 1;
  /// The order is that of a parameter: the last is better than the first, and none worse than one
  /// before it.
  bool monotone = false;
  /// The number of every call is not worse than this, or `same` as it; in the column's unit.
  std::optional<double> bound = std::nullopt;
  /// The numbers of the only group's calls are not to be told apart.
  bool same = false;
  /// With `same`: of ratios from 1, or of numbers from `bound`; nothing: their intervals overlap.
  std::optional<double> within = std::nullopt;
  /// The claim is about these alone; empty: all scenes of the study.
  std::vector<std::string> scenes = {};
  /// The claim is an order of the scenes, the best first, by each call of its own.
  bool orders_scenes = false;
  /// The claim is that it holds on one of its scenes at least: "up to ten times faster".
  bool somewhere = false;
};

/// A ClaimedValue is the number of a call, or of a scene, and where it lies.
struct ClaimedValue {
  std::string of;
  double value = 0;
  std::optional<Interval> interval;  // nothing where it is not known
};

/// A ClaimCheck is a claim on one scene, on the mean over its scenes, or of one call over scenes.
/// It agrees where nothing is against it and nothing undecided.
struct ClaimCheck {
  std::string of;                           // a scene, "mean", or a call
  std::vector<ClaimedValue> values;         // in claimed order
  std::vector<std::string> against = {};    // what is otherwise here, in words
  std::vector<std::string> undecided = {};  // what the intervals leave open, in words
};

/// Returns how the claim stands here: "the same here", "undecided: …" or "otherwise here: …".
std::string verdict(const ClaimCheck& check);

/// Returns a check for each scene of which all the claim's rows are there, in the order of
/// `scenes`, and after them, for more than one scene, that of the mean over those scenes. Of a
/// claim that orders scenes, it returns a check for each call that has all of them; of one that
/// holds somewhere, those of the scenes that agree, where there are any, else those that are
/// undecided, else all. Empty where no row says anything.
///
/// A claim holds where it does for all numbers of the intervals, and is refuted where it does for
/// none; else it is undecided. For the mean over scenes the intervals' ends are averaged, which
/// makes it no narrower than one of 95 %.
std::vector<ClaimCheck> check_claim(const Claim& claim, std::span<const std::string> scenes,
                                    std::span<const ResultRow> rows);

}  // namespace pellucid::compare
