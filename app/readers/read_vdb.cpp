// SPDX-License-Identifier: GPL-3.0-or-later
// pellucid-read-vdb: parses one file for the process that starts it (core/files/child_reader.h).

#include <cstdlib>

#include "core/files/child_reader.h"
#include "readers/vdb/parse_vdb.h"

// What it throws it leaves as its complaint; what a broken library throws besides ends it.
// NOLINTNEXTLINE(bugprone-exception-escape)
int main(int argc, char** argv) {
  // What it has written is there: no library is asked to clean up, which one that a file has
  // damaged may not survive.
  std::_Exit(pellucid::run_child_reader(
      argc, argv,
      [](const std::filesystem::path& file, std::span<const std::string> what,
         pellucid::BlockWriter& out) {
        if (what.size() == 1 && what[0] == "points")
          pellucid::readers::parse_vdb_points(file, out);
        else
          pellucid::readers::parse_vdb_grids(file, what.size() > 1 ? what[1] : "", out);
      }));
}
