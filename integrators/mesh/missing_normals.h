// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/vec.h"

namespace pellucid::integrators {

/// Gives each vertex whose normal is 0 that of the triangles around it, each by its angle there:
/// whatever way a crease's two sides are cut into triangles, both weigh the same. One without a
/// triangle of some area gets (0, 0, 1).
void fill_missing_normals(std::span<const Vec3> positions,
                          std::span<const std::array<std::uint32_t, 3>> triangles,
                          std::span<Vec3> normals);

}  // namespace pellucid::integrators
