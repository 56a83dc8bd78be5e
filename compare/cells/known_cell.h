// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "compare/cells/cell.h"

namespace pellucid::compare {

/// A KnownCell is what some run has left of a cell.
struct KnownCell {
  std::optional<ResultRow> row = std::nullopt;
  std::string fault = {};  // why there is no row though there is a file of one: "of other inputs"
};

/// Reads the row of a cell, finished or failed, by whichever run, for the same fingerprint and from
/// files whose content is as it was; none when the row cannot be read, or when a file that a
/// finished cell has made is gone or its content is not what the row says. What it reads for
/// read_row() and read_finished() is the same.
KnownCell known_cell(const CellFiles& files, const std::string& fingerprint, ContentHashes& hashes);

/// Returns whether the row was made by the build of this id, which alone is kept by who resumes.
bool is_of_build(const ResultRow& row, const std::string& build);

}  // namespace pellucid::compare
