// SPDX-License-Identifier: GPL-3.0-or-later
// pellucid-read-vdb: parses one file by OpenVDB for the process that starts it
// (core/files/child_reader.h).

#include "core/files/child_reader.h"
#include "readers/vdb/parse_vdb.h"

// What a broken library throws besides ends it. NOLINTNEXTLINE(bugprone-exception-escape)
int main(int argc, char** argv) {
  pellucid::run_child_reader(argc, argv,
                             [](const std::filesystem::path& file,
                                std::span<const std::string> what, pellucid::BlockWriter& out) {
                               if (what.size() == 1 && what[0] == "points")
                                 pellucid::readers::parse_vdb_points(file, out);
                               else
                                 pellucid::readers::parse_vdb_grids(
                                     file, what.size() > 1 ? what[1] : "", out);
                             });
}
