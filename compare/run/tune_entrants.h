// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "compare/cells/measure_cell.h"
#include "compare/run/tune.h"

namespace pellucid::compare {

/// An Entrant is a candidate that competes.
struct Entrant {
  MethodCall call;
  std::size_t place;                         // among the candidates
  std::optional<double> small_seconds = {};  // of the small picture; none where time was over
  double small_setup = 0;
  std::unique_ptr<CellMeter> meter = nullptr;  // while it may be timed further
  ResultRow row = {};                          // once the whole picture was drawn
  bool drawn = false, within = false, tied = false;
  bool of_reference = false;  // its row is the reference's, which was drawn before

  /// The least time is nearest to what nothing disturbed.
  double least_seconds() const { return std::ranges::min(meter->seconds()); }
};

/// The least of one or two times is known to such a factor: who takes so many times as long as
/// another is too slow without further ado.
constexpr double hopeless = 8;

/// An IsOver says whether the time for tuning is over: then no further picture is timed.
using IsOver = std::function<bool()>;

/// Returns whether one takes longer than `factor` times the other, by the least of five times each,
/// taken in turn: what disturbs a machine for a while disturbs both.
bool is_slower(CellMeter& one, CellMeter& than, double factor, const IsOver& is_over);

/// Finishes those whose meter says that they are too slow to be the fastest, and all but the twelve
/// fastest, which have their memory at once.
void keep_contenders(std::span<Entrant> entrants, const IsOver& is_over);

/// Takes the row, with the errors that are known, and frees what the method holds.
void finish(Entrant& entrant, const TimingRule& rule);

/// Ties those within the bound that need the fewest bytes, which are the same in every run.
void weigh(std::span<Entrant> entrants);

/// Times those that still have a meter in turn, each at most `repeats` times, and ties the fastest
/// that their intervals do not tell apart. `tell` is told whose turn it is.
void time_contenders(std::span<Entrant> entrants, int repeats, const IsOver& is_over,
                     const std::function<void(const Entrant&)>& tell);

/// Adds the entrants that were drawn to the outcome, the cheapest first; of tied ones the cheapest
/// is that of the fewest bytes, then of the least error, then the first of the candidates.
void rank(std::vector<Entrant> entrants, Cost cost, TuneOutcome& outcome);

}  // namespace pellucid::compare
