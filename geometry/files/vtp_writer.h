// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "geometry/line_set.h"
#include "geometry/point_set.h"
#include "geometry/triangle_mesh.h"

namespace pellucid::geometry {

/// Writes .vtp or .vtu with all attributes, 8 bytes a coordinate and not compressed; points are
/// cells of one point each. The `origin` is a string array of the field data. Throws as OutputFile
/// does.
///@{
void write_vtp(const std::filesystem::path& path, const TriangleMesh& mesh,
               const std::string& origin);
void write_vtp_lines(const std::filesystem::path& path, const LineSet& lines,
                     const std::string& origin);
void write_vtp_points(const std::filesystem::path& path, const PointSet& points,
                      const std::string& origin);
void write_vtu(const std::filesystem::path& path, const TriangleMesh& mesh,
               const std::string& origin);
void write_vtu_lines(const std::filesystem::path& path, const LineSet& lines,
                     const std::string& origin);
void write_vtu_points(const std::filesystem::path& path, const PointSet& points,
                      const std::string& origin);
///@}

}  // namespace pellucid::geometry
