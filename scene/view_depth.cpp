// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/view_depth.h"

#include <algorithm>
#include <limits>
#include <span>

#include "core/error.h"
#include "scene/view/ribbon.h"

namespace pellucid::scene {
namespace {

/// Smallest and largest view depth, world units.
struct DepthBounds {
  double min = std::numeric_limits<double>::infinity();
  double max = -std::numeric_limits<double>::infinity();

  void extend(double z) {
    min = std::min(min, z);
    max = std::max(max, z);
  }
};

class BoundsOfShape {
 public:
  BoundsOfShape(const Camera& camera, DepthBounds& bounds)
      : frame_(camera_frame(camera)), projection_(camera.projection), bounds_(bounds) {}

  void operator()(const geometry::TriangleMesh& mesh) { extend(mesh, 0); }
  void operator()(const PointObject& points) {
    extend(points.set, points.profile == PointObject::Profile::sphere ? points.radius : 0);
  }
  void operator()(const Isosurface& surface) { extend(surface.corners, 0); }
  void operator()(const LineObject& lines) {
    lines.profile == LineObject::Profile::tube ? extend(lines.set, lines.radius)
                                               : extend_ribbons(lines);
  }

 private:
  void extend(const geometry::Vertices& vertices, double radius) {
    for (const Vec3& x : vertices.positions) {
      const double z = view_depth(frame_, x);
      bounds_.extend(z - radius);
      bounds_.extend(z + radius);
    }
  }

  void extend_ribbons(const LineObject& lines) {
    const std::span<const Vec3> points(lines.set.positions);
    for (std::size_t k = 0; k < lines.set.line_count(); ++k) {
      const auto line =
          points.subspan(lines.set.offsets[k], lines.set.offsets[k + 1] - lines.set.offsets[k]);
      ribbon_half_widths(line, lines.radius, frame_, projection_, half_widths_);
      for (std::size_t i = 0; i < line.size(); ++i)
        for (const Vec3& corner : {line[i] - half_widths_[i], line[i] + half_widths_[i]})
          bounds_.extend(view_depth(frame_, corner));
    }
  }

  CameraFrame frame_;
  Projection projection_;
  DepthBounds& bounds_;
  std::vector<Vec3> half_widths_;
};

}  // namespace

DepthRange depth_range(const Scene& scene) {
  DepthBounds bounds;
  BoundsOfShape extend(scene.camera, bounds);
  for (const SceneObject& object : scene.objects) std::visit(extend, object.shape);
  if (!(bounds.max > 0))
    throw InputError(
        "camera: nothing of the scene is in front of it; accepted: an eye and a target "
        "that see the objects");
  // Geometry that reaches behind the eye is seen from the eye on.
  bounds.min = std::max(bounds.min, 0.0);
  const double length = bounds.max - bounds.min;
  // One single depth: any interval around it will do; this one survives rounding to float.
  const double margin = length > 1e-6 * bounds.max ? 1e-5 * length : 0.5 * bounds.max;
  return {bounds.min - margin, bounds.max + margin};
}

}  // namespace pellucid::scene
