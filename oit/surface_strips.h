#pragma once

#include "integrators/surface_particles.h"
#include "scene/scene.h"
#include "scene/view_depth.h"

namespace pellucid {

/// The lines that the particles of a seed curve draw on their surface, each as a strip that lies in
/// the surface's own tangent plane: it is spanned by the velocity v and by ∂x/∂s, which the
/// variational equation carries along. Where a strip covers a pixel's centre, its depth there is
/// the surface's up to the surface's bending within half a strip; a strip that faced the eye would
/// be off by the surface's slope.
///
/// Lines of any numbers can be made in any order and always come out the same.
class SurfaceStrips {
 public:
  /// `width` in pixels at each point's view depth. What it is given has to outlive it.
  SurfaceStrips(const FlowSource& source, const Scene& scene, const DepthRange& range,
                double width);

  /// Lines first … first + count - 1 of the sequence whose seeds fill the curve evenly at every
  /// length (the multiples of the golden ratio modulo 1).
  TriangleMesh lines(std::uint64_t first, std::uint64_t count);

 private:
  TriangleMesh line(double s);
  double pixel_size(const Vec3& x) const;

  const FlowSource& source_;
  CameraFrame frame_;
  Projection projection_;
  double pixel_;    // world units a pixel; perspective: at distance 1
  double nearest_;  // view depths below this count as this: steps stay finite at the eye
  double width_;    // of a strip, pixels
  bool lit_;
  SurfaceRequest request_;
  SurfaceOptions options_;
  ParticleSource particles_;
};

}  // namespace pellucid
