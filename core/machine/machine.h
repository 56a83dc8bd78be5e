// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

namespace pellucid {

/// What a result was made on: "cpu", "cores", "memory_gib", "kernel", "compiler", "version",
/// "commit". The rooms that use a library add its version.
std::map<std::string, std::string> machine_facts();

}  // namespace pellucid
