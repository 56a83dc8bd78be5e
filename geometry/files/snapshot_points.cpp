// SPDX-License-Identifier: GPL-3.0-or-later
// The particles of a simulation's snapshot, which readers/particles/parse_snapshot.cpp finds.
#include <fmt/format.h>

#include "core/error.h"
#include "geometry/files/mesh_formats.h"
#include "geometry/files/point_blocks.h"
#include "readers/particles/snapshot_file.h"

namespace pellucid::geometry {
namespace {

PointSet read_snapshot(const std::filesystem::path& path) {
  try {
    return points_of(readers::read_snapshot_blocks(path));
  } catch (const BlockError& error) {
    throw InputError(fmt::format("{}: not a valid snapshot: {}", path.string(), error.what()));
  }
}

FormatRow snapshot_row(std::string_view ending) {
  return {.ending = ending,
          .title = "particles of GADGET, AREPO, GIZMO and SWIFT, in HDF5",
          .traps =
              "in the file's units; particles of all types, their number the scalar "
              "particle_type; what a type does not have is NaN; of a snapshot in several files "
              "the one that is named",
          .read_points = read_snapshot};
}

}  // namespace

FormatRow hdf5_format() { return snapshot_row(".hdf5"); }

FormatRow h5_format() { return snapshot_row(".h5"); }

}  // namespace pellucid::geometry
