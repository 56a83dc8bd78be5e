#include "groundtruth/marched_isosurface.h"

namespace pellucid {

MarchedIsosurface::MarchedIsosurface(const Isosurface& surface, bool opaque, std::uint32_t index,
                                     const GeometryContext& context, const MarchOptions& options)
    : IsosurfaceGeometry(surface, index, context),
      march_(*surface.field, surface.value, options),
      transmittance_(opaque ? 0 : 1 - double(surface.corners.colors.front().a)),
      stop_below_(options.stop_below) {}

void MarchedIsosurface::cross(std::uint32_t k, const SceneRay& ray,
                              std::vector<Crossing>& crossings) const {
  const WorldRay world = to_world(ray);
  double shows = 1;
  march_.visit_crossings(world, [&](double t) {
    if (append(ray, world, t, k, crossings)) shows *= transmittance_;
    return shows > 0 && shows >= stop_below_;
  });
}

}  // namespace pellucid
