// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "groundtruth/levels/level_march.h"
#include "groundtruth/rays/crossing.h"
#include "groundtruth/rays/exact_sign.h"
#include "groundtruth/traversal/scene_part.h"
#include "scene/scene.h"

namespace pellucid::groundtruth {

/// A CrossingFinder finds every crossing of a ray with a scene. Embree's traversal brings the
/// candidates: its primitives are the boxes of a CrossingGeometry, widened by more than the
/// rounding of rays and boxes to float, so none is missed; the geometry decides each. It is
/// thread-safe once it is made.
class CrossingFinder {
 public:
  /// Builds the hierarchy. The scene has to outlive it. With `march` isosurfaces are marched, not
  /// crossed exactly; a march ends where less than `stop_below` shows through its surface. Throws
  /// InputError for more primitives than a Crossing counts, WorkError when Embree fails.
  CrossingFinder(const scene::Scene& scene, Precision precision,
                 const std::optional<MarchOptions>& march = {}, double stop_below = 0);
  /// Builds the hierarchy of a part of a scene, which has to outlive it: what it finds is what it
  /// would find of the whole with the part's primitives. Their numbers are the part's.
  CrossingFinder(const scene::Scene& part, const WholeScene& whole, Precision precision);
  /// Builds a hierarchy for a scene that turns: its camera, size and halos may change before each
  /// turn(). Traversals take somewhat longer.
  static CrossingFinder turning(const scene::Scene& scene, Precision precision, double stop_below);
  ~CrossingFinder();
  CrossingFinder(CrossingFinder&& other) noexcept;

  /// Takes the scene as it is now, in far less time than building anew takes: the same crossings,
  /// to the last bit, as a new finder finds. Throws as the constructor does.
  void turn();

  const ViewFrame& frame() const;

  /// Finds all crossings of the ray, front to back, up to and with the first opaque one.
  /// `crossings` is overwritten; its capacity is reused. With exact precision those of equal depth
  /// are ordered by object, then by primitive, however their shapes are stored, while depths
  /// themselves may carry some rounding (see round_depths).
  void find(const PictureRay& ray, std::vector<Crossing>& crossings) const;
  /// Finds the crossings of up to RayPacket::width rays at once: faster where they are neighbours.
  /// `crossings` has as many elements as `rays`.
  void find(std::span<const PictureRay> rays, std::span<std::vector<Crossing>> crossings) const;

  /// Gives crossings that find() returned for the ray the depths that decide their order: with
  /// exact precision those of flat shapes are the exact ones, rounded once (see plane_depth.h), so
  /// that the order of several lists' crossings is that of one. Their order does not change.
  void round_depths(const PictureRay& ray, std::span<Crossing> crossings) const;

  /// Returns the colour and opacity of a crossing that find() returned; `world_direction` is its
  /// ray's, of any length.
  Fragment shade(const Crossing& crossing, const Vec3& world_direction) const;
  /// Writes those of several crossings of a ray to `fragments`, which has at least as many
  /// elements.
  void shade(std::span<const Crossing> crossings, const Vec3& world_direction,
             std::span<Fragment> fragments) const;
  /// Returns g at a crossing; 0 where the object has none, and where it is opaque: context.
  double importance(const Crossing& crossing) const;

  std::uint64_t bytes() const;  // of the hierarchy and of what the geometries keep

 private:
  struct State;
  explicit CrossingFinder(std::unique_ptr<State> state);

  std::unique_ptr<State> state_;
};

}  // namespace pellucid::groundtruth
