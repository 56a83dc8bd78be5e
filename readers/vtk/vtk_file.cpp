// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vtk/vtk_file.h"

#include <fmt/format.h>

#include "core/error.h"
#include "core/files/child_reader.h"
#include "readers/vtk/data_set_blocks.h"

namespace pellucid::readers {

vtkSmartPointer<vtkDataSet> read_vtk_data_set(const std::filesystem::path& path) {
  const Blocks blocks = read_in_child("pellucid-read-vtk", path);
  try {
    return data_set_of(blocks);
  } catch (const BlockError& error) {
    throw InputError(fmt::format("{}: not a valid {} file: {}", path.string(),
                                 path.extension().string(), error.what()));
  }
}

}  // namespace pellucid::readers
