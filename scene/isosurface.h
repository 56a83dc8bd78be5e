#pragma once

#include <memory>
#include <optional>

#include "geometry/vertices.h"

namespace pellucid {

class LevelField;

/// Where a scalar on levels of samples takes a value. Of one colour.
struct Isosurface {
  struct Ball {
    Vec3 center{0};
    double radius = 0;  // world
  };

  std::shared_ptr<const LevelField> field;
  double value = 0;
  std::optional<Ball> hole;  // nothing of the surface is drawn within
  Vertices corners;          // the eight of its field's bounds; each has the surface's colour

  bool cuts_away(const Vec3& x) const {
    return hole && glm::length(x - hole->center) < hole->radius;
  }
};

/// Of the field's bounds.
inline Vertices corners_of(const Box3& box) {
  Vertices corners;
  for (int corner = 0; corner < 8; ++corner)
    corners.positions.emplace_back(corner & 1 ? box.max.x : box.min.x,
                                   corner & 2 ? box.max.y : box.min.y,
                                   corner & 4 ? box.max.z : box.min.z);
  return corners;
}

}  // namespace pellucid
