// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <variant>

#include "geometry/vertices.h"
#include "scene/appearance/appearance.h"

namespace pellucid::fields {
class LevelField;
}
namespace pellucid::geometry {
class SolidMesh;
}

namespace pellucid::scene {

class Colormap;
struct ColormapRow;

/// An Isosurface is where a scalar on levels of samples takes a value, in world coordinates.
struct Isosurface {
  /// A Ball is all within a distance of a point.
  struct Ball {
    Vec3 center{0};     // world
    double radius = 0;  // world
  };
  /// A Body is a solid, and all within a distance of it.
  struct Body {
    std::shared_ptr<const geometry::SolidMesh> solid;
    double distance = 0;  // world
  };

  /// An OtherScalar is a scalar where the surface is, reconstructed as the surface's own.
  struct OtherScalar {
    std::shared_ptr<const fields::LevelField> field;  // on the same levels
    Vec2 range{0, 1};                                 // in the scalar's unit
    Scale scale = Scale::linear;                      // of the range

    double fraction(const Vec3& x) const;  // of the range
  };
  /// A Coloring colours the surface by a scalar through a colour map.
  struct Coloring {
    OtherScalar scalar;
    const ColormapRow* map = nullptr;                  // from end to end of the range
    std::shared_ptr<const Colormap> custom = nullptr;  // in the place of `map`
    std::optional<Vec3> nan = std::nullopt;            // of NaN, in the place of the map's

    Vec3 color(double fraction) const;
  };
  /// A Fading gives the opacity by a transfer function: linear from end to end of a scalar's range,
  /// constant beyond.
  struct Fading {
    OtherScalar scalar;
    Vec2 opacities{0, 1};  // at the ends of the range, each in [0, 1]

    float opacity(const Vec3& x) const;
  };

  std::shared_ptr<const fields::LevelField> field;
  double value = 0;                               // in the scalar's unit
  std::optional<Coloring> coloring;               // none: the colour of `corners`
  std::optional<Fading> fading;                   // none: the opacity of `corners`
  std::variant<std::monostate, Ball, Body> hole;  // nothing of the surface is drawn within
  geometry::Vertices corners;  // the eight of its field's bounds: the surface's colour and opacity

  /// Says whether x, in the world, lies in the hole.
  bool cuts_away(const Vec3& x) const;
};

/// Returns the eight corners of a box in the world, for Isosurface::corners; the first axis runs
/// fastest.
inline geometry::Vertices corners_of(const Box3& box) {
  geometry::Vertices corners;
  for (int corner = 0; corner < 8; ++corner)
    corners.positions.emplace_back(corner & 1 ? box.max.x : box.min.x,
                                   corner & 2 ? box.max.y : box.min.y,
                                   corner & 4 ? box.max.z : box.min.z);
  return corners;
}

}  // namespace pellucid::scene
