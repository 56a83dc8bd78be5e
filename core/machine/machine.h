// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

namespace pellucid {

/// Returns what a result was made on, by name: "cpu", "cores", "memory_gib" (GiB), "kernel",
/// "compiler", "version", "commit", "build" (build_id()). The rooms that use a library add its
/// version.
std::map<std::string, std::string> machine_facts();

}  // namespace pellucid
