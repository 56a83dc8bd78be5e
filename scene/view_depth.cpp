#include "scene/view_depth.h"

#include <algorithm>
#include <limits>

#include "core/error.h"

namespace pellucid {
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

}  // namespace

DepthRange depth_range(const Scene& scene) {
  const CameraFrame frame = camera_frame(scene.camera);
  DepthBounds bounds;
  for (const SceneObject& object : scene.objects)
    for (const Vec3& x : object.mesh.positions) bounds.extend(view_depth(frame, x));
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

}  // namespace pellucid
