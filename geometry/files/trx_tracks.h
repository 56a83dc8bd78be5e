// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/blocks.h"
#include "geometry/files/from_file.h"

namespace pellucid::geometry {

/// Returns the lines of a .trx file, of which `files` are the members: positions in scanner
/// coordinates (RAS, mm), and scalars of its data per vertex and, at each of a line's points, per
/// streamline. Throws BlockError for members that do not fit together.
FileLines lines_of_trx(const Blocks& files);

}  // namespace pellucid::geometry
