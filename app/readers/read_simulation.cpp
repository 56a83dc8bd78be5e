// SPDX-License-Identifier: GPL-3.0-or-later
// pellucid-read-simulation: parses one file by VTK for the process that starts it
// (core/files/child_reader.h).

#include "core/files/child_reader.h"
#include "readers/vtk/parse_file.h"
#include "readers/vtk/write_parsed.h"

// What a broken library throws besides ends it. NOLINTNEXTLINE(bugprone-exception-escape)
int main(int argc, char** argv) {
  namespace readers = pellucid::readers;
  pellucid::run_child_reader(
      argc, argv,
      [](const std::filesystem::path& file, std::span<const std::string> arguments,
         pellucid::BlockWriter& out) {
        readers::write_parsed(file, readers::simulation_readers(), arguments, out);
      });
}
