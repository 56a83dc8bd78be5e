// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Everything that exact compositing knows of one ray: what order-independent methods approximate.

#include <span>
#include <vector>

#include "groundtruth/traversal/crossing_finder.h"
#include "scene/view_depth.h"

namespace pellucid::groundtruth {

/// A RayLayer is a crossing, and the sums from the eye to it; i counts crossings front to back,
/// from 1.
struct RayLayer {
  double depth;          // view depth, world units
  double d;              // in (0, 1), see DepthRange
  std::uint32_t object;  // index in Scene::objects
  std::uint32_t primitive;
  Vec3 color;             // lit, straight
  double opacity;         // α_i; 1 where the object is opaque
  double importance;      // g_i; 0 where the object is opaque
  double transmittance;   // Π_{j<i} (1 - α_j): of all that lies in front
  double importance_sum;  // G(d_i) = Σ_{j≤i} g_j², Baeza Rojo et al. 2019, Eq. 10
  double optical_depth;   // τ(d_i) = Σ_{j≤i} -ln(1 - α_j), Eq. 14; infinite from α = 1 on
};

/// RaySums are the layers along a ray, up to and with the first opaque one, and its colour.
struct RaySums {
  std::vector<RayLayer> layers;  // front to back
  Vec3 color{0};                 // composited over the background, Eq. 12
  double transmittance = 1;      // of all layers

  /// Returns G(d) (importance_sum) or τ(d): the sums over all layers at depths up to and with d.
  ///@{
  double importance_sum(double d) const;
  double optical_depth(double d) const;
  ///@}
};

/// A RayProbe asks a scene for rays, one by one. It is thread-safe once it is made.
class RayProbe {
 public:
  /// Builds the hierarchy. The scene has to outlive it. Throws InputError when nothing of it is in
  /// front of the camera, and as CrossingFinder does.
  explicit RayProbe(const scene::Scene& scene, Precision precision = Precision::exact);
  /// Builds the hierarchy of a part of a scene, which has to outlive it. Each of the part's
  /// crossings is, to the last bit, what it is in the whole: its place, its look and its numbers.
  /// Sums are the part's own.
  explicit RayProbe(const ScenePart& part);

  /// Returns the sums along the ray through a point: x runs right, y down, in pixels from the
  /// picture's top left corner; a pixel's centre is at +0.5.
  RaySums at(double x, double y) const;
  /// Returns the sums at several such points, best neighbours; computed in parallel.
  std::vector<RaySums> at(std::span<const Vec2> places) const;

  const scene::DepthRange& depths() const { return depths_; }
  std::uint64_t bytes() const { return finder_.bytes(); }  // of the hierarchy and what it needs

 private:
  RaySums sums(const PictureRay& ray, std::span<const Crossing> crossings) const;

  const scene::Scene& scene_;
  scene::DepthRange depths_;
  CrossingFinder finder_;
  std::vector<std::uint32_t> first_primitives_;  // in the whole, by object; empty: 0
};

}  // namespace pellucid::groundtruth
