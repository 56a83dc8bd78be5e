// SPDX-License-Identifier: GPL-3.0-or-later
// pellucid-read-vtk: parses one file by VTK for the process that starts it
// (core/files/child_reader.h).

#include <vtkDataSet.h>

#include "core/files/child_reader.h"
#include "readers/vtk/data_set_blocks.h"
#include "readers/vtk/parse_file.h"

// What a broken library throws besides ends it. NOLINTNEXTLINE(bugprone-exception-escape)
int main(int argc, char** argv) {
  pellucid::run_child_reader(argc, argv,
                             [](const std::filesystem::path& file, std::span<const std::string>,
                                pellucid::BlockWriter& out) {
                               pellucid::readers::write_data_set(
                                   *pellucid::readers::parse_vtk_file(file), out);
                             });
}
