// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "compare/results/result_row.h"

namespace pellucid::compare {

/// Returns one sentence for each reason why numbers of these rows may not be compared with each
/// other: they come from several builds of the program, their times from several machines, or from
/// one that was disturbed (time_warnings()).
std::vector<std::string> provenance_warnings(std::span<const ResultRow> rows);

}  // namespace pellucid::compare
