// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/finite_vertices.h"

#include <fmt/format.h>

#include <cmath>

#include "core/error.h"

namespace pellucid::geometry {

void check_finite(std::string_view what, const Vertices& vertices) {
  for (std::size_t i = 0; i < vertices.positions.size(); ++i) {
    const Vec3& x = vertices.positions[i];
    if (!std::isfinite(x.x) || !std::isfinite(x.y) || !std::isfinite(x.z))
      throw InputError(
          fmt::format("{}: vertex {} came out at ({}, {}, {}); accepted: positions "
                      "that are finite numbers",
                      what, i, x.x, x.y, x.z));
  }
}

}  // namespace pellucid::geometry
