// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "compare/export/camera_matrices.h"
#include "compare/export/exported_object.h"

namespace pellucid::compare {

/// Writes the objects and the camera as binary glTF 2.0: triangles, LINES and POINTS with COLOR_0
/// (RGBA, floats) and materials that blend (opaque ones do not) and are drawn from both sides,
/// unlit where the light is in the colours. Colours are display values, as they stand, although
/// glTF takes COLOR_0 for linear; radii are in each mesh's `extras`. Returns false, and writes
/// nothing, when it would exceed the 4 GiB that the format holds. Throws WorkError when the file
/// cannot be written.
bool write_gltf(const std::filesystem::path& path, const scene::Scene& scene,
                const CameraMatrices& camera, const std::vector<ExportedObject>& objects);

}  // namespace pellucid::compare
