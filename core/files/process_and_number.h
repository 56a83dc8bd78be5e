// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace pellucid {

/// Returns "PID-N", another one at each call: a name for what only this caller of this process
/// makes.
std::string process_and_number();

}  // namespace pellucid
