// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/files/mesh_formats.h"

#include <algorithm>

#include "core/files/ending.h"

namespace pellucid::geometry {

// Each is defined where the format is read.
FormatRow ply_format();
FormatRow obj_format();
FormatRow vtp_format();
FormatRow vtu_format();
FormatRow legacy_vtk_format();
FormatRow binlines_format();
FormatRow csv_format();
FormatRow vdb_format();
FormatRow stl_format();
FormatRow off_format();
FormatRow tck_format();
FormatRow trk_format();
FormatRow trx_format();
FormatRow hair_format();
FormatRow gltf_format();
FormatRow glb_format();
FormatRow hdf5_format();
FormatRow h5_format();

std::span<const FormatRow> mesh_formats() {
  static const FormatRow rows[] = {
      ply_format(),      obj_format(),  vtp_format(), vtu_format(), legacy_vtk_format(),
      binlines_format(), csv_format(),  vdb_format(), stl_format(), off_format(),
      gltf_format(),     glb_format(),  tck_format(), trk_format(), trx_format(),
      hair_format(),     hdf5_format(), h5_format()};
  return rows;
}

const FormatRow* mesh_format(const std::filesystem::path& path) {
  const auto formats = mesh_formats();
  const auto found = std::ranges::find(formats, small_ending(path), &FormatRow::ending);
  return found == formats.end() ? nullptr : &*found;
}

}  // namespace pellucid::geometry
