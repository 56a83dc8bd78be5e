// SPDX-License-Identifier: GPL-3.0-or-later
// pellucid-read-hdf5: reads the particles of one snapshot by HDF5 for the process that starts it
// (core/files/child_reader.h).

#include "core/files/child_reader.h"
#include "readers/particles/parse_snapshot.h"

// What a broken library throws besides ends it. NOLINTNEXTLINE(bugprone-exception-escape)
int main(int argc, char** argv) {
  pellucid::run_child_reader(
      argc, argv,
      [](const std::filesystem::path& file, std::span<const std::string>,
         pellucid::BlockWriter& out) { pellucid::readers::parse_snapshot(file, out); });
}
