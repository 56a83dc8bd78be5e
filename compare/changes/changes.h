// SPDX-License-Identifier: GPL-3.0-or-later
// What has changed between two runs of a study: numbers beyond their spread, pictures, cells.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "compare/changes/past_run.h"
#include "compare/timing/median_interval.h"

namespace pellucid::compare {

/// What two float pictures, of one arithmetic on two machines, may differ by: 2^-20, sixteen steps
/// of a float below 1. A composite of some hundred layers has been rounded as often, half of it up.
constexpr double rounding_of_picture = 0x1p-20;

/// A NumberChange is a number of a cell that differs beyond its spread.
struct NumberChange {
  std::string title;  // with its unit, as people read it: "Time [ms]"
  std::string before, after;
  bool is_time = false;
  std::optional<bool> better = std::nullopt;  // nothing where no way is better
};

/// A PictureChange says where two pictures of a cell differ.
struct PictureChange {
  std::size_t view = 0;    // counted from 0
  std::string why_not;     // where they could not be compared: one is not there, or their sizes
  std::size_t pixels = 0;  // that are not the same to the last bit
  double largest = 0;      // difference of one value, red, green, blue or alpha
  int x = 0, y = 0;        // the first pixel that differs, row by row from the top
  bool beyond_rounding() const { return !why_not.empty() || largest > rounding_of_picture; }
};

/// A CellChange is a cell of either run, and what is otherwise in the second.
struct CellChange {
  enum class Kind { same, changed, missing, added };

  std::string cell;  // "abc/fourier:bands=5"
  Kind kind = Kind::same;
  std::vector<NumberChange> numbers;
  std::vector<PictureChange> pictures;  // those not the same to the last bit
  std::vector<std::string> causes;      // why it may be otherwise: other inputs, another request
};

/// RunChanges are all of it.
struct RunChanges {
  std::vector<CellChange> cells;      // in the first run's order; then those that it has not
  std::vector<std::string> warnings;  // builds or machines differ: see provenance_warnings()

  /// Says whether a cell, a picture beyond rounding or a number differs; times where they count.
  bool differ(bool times_count) const;
};

/// Compares two runs cell by cell. A number with an interval differs where the two intervals have
/// nothing in common; a time without one is not judged, nor is one from a single picture. A metric
/// differs beyond `rounding_of_picture`, FLIP beyond 1e-4; PSNR and numbers of 8-bit values say the
/// same again and are passed over. Counts are exact, bytes but for what threads have of their own.
/// Shares of an error's budget differ beyond what such a rounding makes of them. Throws InputError
/// where the runs are of different studies or have no cell in common.
RunChanges compare_runs(const PastRun& before, const PastRun& after);

/// Writes all of it for programs.
nlohmann::json to_json(const RunChanges& changes);

/// Writes what differs, a line each, for people.
std::vector<std::string> lines_of(const RunChanges& changes);

}  // namespace pellucid::compare
