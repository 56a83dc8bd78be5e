// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <variant>

#include "geometry/vertices.h"

namespace pellucid::fields {
class LevelField;
}
namespace pellucid::geometry {
class SolidMesh;
}

namespace pellucid::scene {

struct ColormapRow;

/// Where a scalar on levels of samples takes a value.
struct Isosurface {
  struct Ball {
    Vec3 center{0};
    double radius = 0;  // world
  };
  /// A solid, and all within this distance of it.
  struct Body {
    std::shared_ptr<const geometry::SolidMesh> solid;
    double distance = 0;  // world
  };

  /// A scalar where the surface is, reconstructed as the surface's own.
  struct OtherScalar {
    std::shared_ptr<const fields::LevelField> field;  // on the same levels
    Vec2 range{0, 1};

    double fraction(const Vec3& x) const;  // of the range
  };
  struct Coloring {
    OtherScalar scalar;
    const ColormapRow* map = nullptr;  // from end to end of the range

    Vec3 color(double fraction) const;
  };
  /// Opacity by a transfer function: linear from end to end of the range, constant beyond.
  struct Fading {
    OtherScalar scalar;
    Vec2 opacities{0, 1};

    float opacity(const Vec3& x) const;
  };

  std::shared_ptr<const fields::LevelField> field;
  double value = 0;
  std::optional<Coloring> coloring;               // none: the colour of `corners`
  std::optional<Fading> fading;                   // none: the opacity of `corners`
  std::variant<std::monostate, Ball, Body> hole;  // nothing of the surface is drawn within
  geometry::Vertices corners;  // the eight of its field's bounds: the surface's colour and opacity

  bool cuts_away(const Vec3& x) const;
};

/// Of the field's bounds.
inline geometry::Vertices corners_of(const Box3& box) {
  geometry::Vertices corners;
  for (int corner = 0; corner < 8; ++corner)
    corners.positions.emplace_back(corner & 1 ? box.max.x : box.min.x,
                                   corner & 2 ? box.max.y : box.min.y,
                                   corner & 4 ? box.max.z : box.min.z);
  return corners;
}

}  // namespace pellucid::scene
