// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "compare/run/run_study.h"

namespace pellucid::compare {

/// A MissingCell is a cell of a study without a row that holds.
struct MissingCell {
  std::string cell;   // "SCENE/METHOD:PARAMETERS"
  std::string fault;  // why its row does not hold, see KnownCell; empty where it has none

  /// Returns its name and, where there is a row, what is wrong with it.
  std::string text() const;
};

/// A Collection is what is known of a study whose cells were computed one by one.
struct Collection {
  std::vector<ResultRow> rows;       // in the study's order; failed ones, too
  std::vector<MissingCell> missing;  // in the study's order
};

/// Reads the rows that there are in the folder of a study's cells, whichever build and machine made
/// them, and writes tables and report of them (write_results()). Cells whose scene's reference has
/// failed are rows that have failed, as run_study() has them. Throws WorkError, and writes nothing,
/// when no cell is there.
Collection collect_study(const Study& study, const StudyOptions& options);

}  // namespace pellucid::compare
