// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "core/files/blocks.h"
#include "readers/vtk/parse_file.h"

namespace pellucid::readers {

/// Parses a file and writes what read_vtk_file() reads: per time number N the data set's blocks
/// "blocks" and "left out" (names, one a line) within "N|", the "times" that are, and all of the
/// file, "all times". `arguments` are the request's block, time and arrays.
void write_parsed(const std::filesystem::path& path, std::span<const VtkReader> readers,
                  std::span<const std::string> arguments, BlockWriter& out);

}  // namespace pellucid::readers
