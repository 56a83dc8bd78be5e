// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "app/info/contents.h"
#include "core/progress.h"

namespace pellucid::app {

/// Looks at any file that geometry, fields, pictures or scenes are read from, by its ending. Throws
/// InputError for what its reader refuses, and for other endings, with those that are known.
FileContents inspect(const std::filesystem::path& path, const Progress& progress);

// Each looks at one kind of file.

/// VTK's data sets: their own arrays, at points and at cells.
FileContents inspect_vtk(const std::filesystem::path& path);
/// MetaImages, as VTK would have them.
FileContents inspect_meta_image(const std::filesystem::path& path);
/// OpenVDB's grids, an array each; points have their attributes.
FileContents inspect_vdb(const std::filesystem::path& path);
/// Geometry as it is drawn: of triangles, lines and points what the file has.
FileContents inspect_geometry(const std::filesystem::path& path);
/// Lists of files over time: their times, and what the first of them holds. Throws InputError for a
/// list of lists.
FileContents inspect_list(const std::filesystem::path& path, const Progress& progress);
/// Pictures, a channel an array.
FileContents inspect_picture(const std::filesystem::path& path);
/// Scenes, ready to be drawn.
FileContents inspect_scene(const std::filesystem::path& path, const Progress& progress);

}  // namespace pellucid::app
