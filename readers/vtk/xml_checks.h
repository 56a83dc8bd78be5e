// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "readers/vtk/vtk_formats.h"

namespace pellucid::readers {

/// Says whether a format is VTK's XML.
bool is_xml(const VtkFormat& format);

/// Looks at the tags of one of VTK's XML files, and of those that it names, before VTK does. Throws
/// InputError, which names the file, the attribute and its value, where an attribute is not what
/// it has to be (numbers, so many of them; one of some words): VTK would put its default in its
/// place. And it does so where pieces do not make up a whole (see check_extents()), or differ in
/// what VTK takes for the same (see xml_pieces.h).
void check_xml(const std::filesystem::path& path);

}  // namespace pellucid::readers
