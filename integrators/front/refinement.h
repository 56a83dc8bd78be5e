// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/options/option_table.h"
#include "integrators/front/front_particle.h"
#include "integrators/front/surface_particles.h"
#include "integrators/paths/segment_distance.h"

namespace pellucid::integrators {

/// When a front is fine enough: by the distance of neighbours, as the papers have it, or by the
/// distance of mesh and surface.
struct Refinement {
  double threshold = 0;  // world units: widest ribbon; 0: by tolerance
  double tolerance = 0;  // world units: largest distance of mesh and surface; 0: by threshold
  double step = 0;       // world units: at most between the vertices of a trajectory; 0: any

  bool by_tolerance() const { return tolerance > 0; }
  /// The sagitta that an edge may have. Over a triangle a quadratic surface strays at most 4/3 of
  /// its edges' largest sagitta.
  double largest_sagitta() const { return 0.75 * tolerance; }
  /// The sagitta that a step along a trajectory may have: half of it, since a diagonal spans a step
  /// and the ribbon's lean. Without that margin every lean asks for ribbons so narrow that it
  /// vanishes beside the step, and their triangles tilt (Schwarz's lantern).
  double largest_step_sagitta() const { return 0.5 * largest_sagitta(); }
};

/// When a front is fine enough, as a user has it.
struct RefinementOptions {
  std::optional<double> threshold;  // world units; not set: the row's own, unless by tolerance
  std::optional<double> tolerance;  // world units; not set: by threshold
  std::optional<double> step;  // world units, beside the tolerance's own; not set: by threshold
  double facet_angle = 25;     // degrees: facets farther from their corners' normals are mended
};

/// `default_threshold`, in world units, is the row's own.
OptionTable<RefinementOptions> refinement_options(double default_threshold);

/// Throws InputError when both threshold and tolerance are given. By default a trajectory has
/// `steps_per_threshold` vertices over a threshold's length.
Refinement refinement_of(const RefinementOptions& options, double default_threshold,
                         double steps_per_threshold);

/// World units: edges as short are not refined for their normals' sake. Around a point where the
/// surface has no normal that would not end.
double shortest_edge(const Refinement& refinement);

/// Does the front need a particle between the two? `sagitta`, in world units, is how far the
/// surface between them is from the edge between their heads; it is only asked for by tolerance.
bool asks_for_more(const Refinement& refinement, const Abreast& two, double sagitta);

/// May the front do without a particle between the two that stands `sagitta` from the edge between
/// their heads? Far from the limits of asks_for_more, so that particles do not come and go.
bool can_do_without(const Refinement& refinement, const Abreast& two, double sagitta);

/// Is the triangle neither a sliver nor turned over against the surface?
bool is_well_shaped(const FrontPoint& a, const FrontPoint& b, const FrontPoint& c);

/// The better the triangle, the larger: first that it faces its corners' normals within 30°, then
/// its smallest angle.
double well_shapedness(const FrontPoint& a, const FrontPoint& b, const FrontPoint& c);

/// How long a particle may go before its next vertex, by what is known at the head. Neighbours,
/// where there are any, keep the triangles in shape.
double planned_step(const Refinement& refinement, const Trajectory& path, const FrontPoint& head,
                    const FrontPoint* left, const FrontPoint* right);

/// Returns that step once the path is known up to `next`: infinite when it may go there and beyond.
double allowed_step(const Refinement& refinement, const Trajectory& path, const FrontPoint& head,
                    const FrontPoint* left, const FrontPoint* right, const FrontPoint& next);

/// The vertex after the one at `head`; nothing when the particle ends there. What is left at the
/// end of a trajectory is shared out, so that no sliver remains.
std::optional<FrontPoint> next_vertex(const Refinement& refinement, Trajectory& path,
                                      const FrontPoint& head, const FrontPoint* left,
                                      const FrontPoint* right, fields::FieldSampler& sampler);

}  // namespace pellucid::integrators
