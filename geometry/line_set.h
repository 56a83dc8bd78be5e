#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/vec.h"

namespace pellucid {

/// Polylines: line k joins the points offsets[k] … offsets[k + 1] - 1.
struct LineSet {
  std::vector<Vec3> positions;  // world
  std::vector<std::uint64_t> offsets{0};
  std::map<std::string, std::vector<double>> scalars;  // per point, by name

  std::size_t line_count() const { return offsets.size() - 1; }
};

}  // namespace pellucid
