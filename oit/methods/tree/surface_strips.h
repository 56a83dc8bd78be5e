// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/options/option_table.h"
#include "integrators/front/surface_particles.h"
#include "integrators/lines/line_seeds.h"
#include "oit/methods/tree/mesh_opacity.h"
#include "scene/scene.h"
#include "scene/view_depth.h"

namespace pellucid::oit {

/// A LineSeeding says where on the seed curve lines begin.
enum class LineSeeding {
  separation,  // more lines where neighbours part
  uniform      // evenly many in s
};

/// StripOptions say how wide the lines are drawn, and where they begin.
struct StripOptions {
  double width = 1;   // pixels, at each point's view depth
  double widest = 8;  // pixels: a strip widens so far to reach the next lines
  LineSeeding seeding = LineSeeding::separation;

  bool operator==(const StripOptions&) const = default;
};
/// Returns the table of StripOptions.
const OptionTable<StripOptions>& strip_options();

/// The lines that the particles of a seed curve draw on their surface, each as a strip that lies in
/// the surface's own tangent plane: it is spanned by the velocity v and by ∂x/∂s, which the
/// variational equation carries along. Where a strip covers a pixel's centre, its depth there is
/// the surface's up to the surface's bending within half a strip; a strip that faced the eye would
/// be off by the surface's slope.
///
/// A strip's colour and opacity are those of the surface's appearance, at its own scalars. Where
/// the scene's opacities were optimized, which the appearance knows nothing of, its opacity is that
/// of the surface's mesh at the strip's (s, t).
///
/// Lines of any numbers can be made in any order and always come out the same.
class SurfaceStrips {
 public:
  /// Takes an object that has a source. `lines` is how many there will be, for the distance between
  /// them. What it is given has to outlive it.
  SurfaceStrips(const scene::SceneObject& object, const scene::Scene& scene,
                const scene::DepthRange& range, std::uint64_t lines, const StripOptions& options);

  /// Lines first … first + count - 1 of LineSeeds.
  geometry::TriangleMesh lines(std::uint64_t first, std::uint64_t count);

  /// Returns what it keeps of the mesh; 0 where opacities are the appearance's.
  std::uint64_t bytes() const { return mesh_opacity_ ? mesh_opacity_->bytes() : 0; }

 private:
  template <class Visit>
  void follow(double s, Visit&& visit);
  geometry::TriangleMesh line(const integrators::LineSeeds::Seed& seed);
  double largest_separation(double s);
  double pixel_size(const Vec3& x) const;
  bool is_in_picture(const Vec3& x) const;

  const scene::FlowSource& source_;
  std::uint64_t line_count_;
  StripOptions options_;
  scene::CameraFrame frame_;
  scene::Projection projection_;
  double half_width_, half_height_;  // of the picture, world units; perspective: at distance 1
  double pixel_;                     // likewise, of a pixel
  double nearest_;  // view depths below this count as this: steps stay finite at the eye
  bool lit_;
  integrators::SurfaceRequest request_;
  integrators::SurfaceSetup integration_;
  integrators::ParticleSource particles_;
  integrators::LineSeeds seeds_;
  std::optional<MeshOpacity> mesh_opacity_;  // where opacities are not the appearance's
};

}  // namespace pellucid::oit
