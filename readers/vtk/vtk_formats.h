// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace pellucid::readers {

/// Beside says which other files VTK reads with one: those its XML names; that of the same name
/// whose ending is `second`; those an EnSight case names; those of an OpenFOAM case's folders;
/// those an NRRD header names.
enum class Beside { nothing, named, second, folder, tree, header };

/// One kind of file that VTK reads. Which of VTK's readers it is stands in the program's own table
/// (parse_file.cpp, parse_simulation.cpp).
struct VtkFormat {
  std::string_view ending;  // ".vti"
  std::string_view title;
  std::string_view
      program;  // that parses it: loading all of VTK's readers takes longer than most files
  Beside beside = Beside::nothing;
  std::string_view second = {};  // ".q"
  std::string_view traps = {};   // what to know of it, for the documents
  bool without_arrays = false;   // a shape alone: no field
};

/// Returns the table.
std::span<const VtkFormat> vtk_formats();

/// Returns the row that the path ends as, in small or capital letters, or nullptr.
const VtkFormat* vtk_format(const std::filesystem::path& path);

/// Returns the other files that VTK reads together with this one, by its row; such that are there.
/// Limits of the program that parses it count their bytes; they are inputs, which none overwrites.
/// Throws InputError where it names a pipe or a device.
std::vector<std::filesystem::path> files_beside(const std::filesystem::path& path,
                                                const VtkFormat& format);

}  // namespace pellucid::readers
