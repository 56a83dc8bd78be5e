// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "scene/view/camera.h"

namespace pellucid::scene {

/// Reads the cameras of a file in which ParaView keeps a view's (.pvcc) or its whole state (.pvsm):
/// one for each view of things in space, in the file's order. Throws InputError for what is no XML,
/// and for a view whose camera is not whole.
std::vector<Camera> read_paraview_cameras(const std::filesystem::path& path);

}  // namespace pellucid::scene
