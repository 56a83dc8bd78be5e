// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "geometry/line_set.h"
#include "geometry/triangle_mesh.h"

namespace pellucid::geometry {

/// Writes .vtp with all attributes, 8 bytes a coordinate and not compressed. Throws as
/// OutputFile does.
///@{
void write_vtp(const std::filesystem::path& path, const TriangleMesh& mesh);
void write_vtp_lines(const std::filesystem::path& path, const LineSet& lines);
///@}

}  // namespace pellucid::geometry
