// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compare/study/claims.h"

namespace pellucid::compare {

/// A Ladder is a row of scenes that get harder in one quantity: 1, 2, 1000, … layers.
struct Ladder {
  std::string title;                // the quantity: "Layers in a pixel"
  ClaimedNumber by;                 // what breaks
  double bound = 0;                 // a method breaks where its number is worse than this
  std::vector<std::string> scenes;  // by name, the easiest first
};

/// A BreakPoint is the first scene of a ladder at which a method breaks.
struct BreakPoint {
  std::optional<std::string> scene = std::nullopt;  // nothing: it holds to the end
  std::optional<double> value = std::nullopt;       // there; nothing where the method failed
  bool measured = true;                             // false: a scene before it was not
};

/// Returns where `call` breaks on the ladder, by the rows of a study: where its number is worse
/// than the bound or not finite, or where it failed.
BreakPoint break_point(const Ladder& ladder, const std::string& call,
                       std::span<const ResultRow> rows);

/// Returns "depths-equal (6.2e-02)", "scale-1e10 (failed)", "holds", or "–" where a scene before
/// was not measured.
std::string text_of(const BreakPoint& point, const Ladder& ladder);

/// A LadderTable has a line for each call, with a text for each ladder.
struct LadderTable {
  std::vector<std::string> heads;  // "Layers in a pixel: RMSE above 0.01"
  std::vector<std::pair<std::string, std::vector<std::string>>> lines;
};

/// Returns the table of all calls that have rows, in their order, the reference left out; no lines
/// where there are no ladders.
LadderTable ladder_table(std::span<const Ladder> ladders, std::span<const ResultRow> rows);

}  // namespace pellucid::compare
