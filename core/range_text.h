// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

namespace pellucid {

/// Returns the text of the two ends of a range: in six digits, or in as many as it takes to have
/// each right to a hundredth of their difference.
std::array<std::string, 2> range_ends(double low, double high);

/// Returns "LOW … HIGH" in the same way.
std::string range_text(double low, double high);

}  // namespace pellucid
