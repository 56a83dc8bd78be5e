// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/changes/changes.h"

namespace pellucid::compare {

/// Returns the numbers of a cell that differ between two rows without an error beyond their spread.
std::vector<NumberChange> number_changes(const ResultRow& before, const ResultRow& after);

}  // namespace pellucid::compare
