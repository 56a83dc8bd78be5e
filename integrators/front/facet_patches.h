// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A heavy header, by OpenMesh: include it in .cpp files alone.

#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "geometry/surface_mesh.h"
#include "integrators/front/surface_builder.h"
#include "integrators/mesh/disjoint_sets.h"

namespace pellucid::integrators {

/// Returns the cosine between a facet's normal and that of the corner where it differs most, of
/// corners that have one; -1 of a facet without an area.
double facet_cosine(const SurfaceBuilder& builder, const geometry::Corners& corners);

/// Returns how far an edge is from the surface at its middle, world units, as far as the normals at
/// its ends tell: the sagitta of an arc whose chord leaves the tangent planes as the edge does.
double sagitta_of(const SurfaceBuilder& builder, std::uint32_t a, std::uint32_t b);

/// What mending is judged by.
struct FacetMeasure {
  double smallest_cosine;  // facets whose facet_cosine() is below are off
  double near_enough;      // world units: edges that are no farther from the surface do no harm
};

/// FacetPatches are the parts of a mesh that edits have changed, each with all the vertices that
/// its edits touched, so that no two of them have a facet or a vertex in common: whatever became of
/// one of them can be undone alone.
class FacetPatches {
 public:
  using Facets = std::vector<std::optional<geometry::Corners>>;  // nothing where one was removed

  /// Keeps the builder's facets, which are to be edited; it must outlive this.
  FacetPatches(const SurfaceBuilder& builder, const FacetMeasure& measure);

  /// Says that an edit has changed facets between these vertices.
  void join(std::span<const std::uint32_t> vertices);
  /// Takes those patches back that are no better in `after`, where facets have kept their numbers
  /// and new ones follow. A patch is better when less of it is off, by area, no more of it is
  /// turned over, its worst facet no worse, and its edges no farther from the surface. Returns the
  /// facets there are then.
  std::vector<geometry::Corners> better_of(const Facets& after);
  /// Returns true when better_of() has taken the vertex's patch back.
  bool is_taken_back(std::uint32_t vertex);

 private:
  /// How a patch's facets face, areas in world units², and how far its edges are from the surface.
  struct Standing {
    double worst = 1, off = 0, turned = 0, away = 0;
  };
  using Standings = std::unordered_map<std::size_t, Standing>;  // by patch

  void add(Standings& standings, const geometry::Corners& corners);
  void compare(const Facets& after);

  const SurfaceBuilder& builder_;
  FacetMeasure measure_;
  std::vector<geometry::Corners> before_;
  DisjointSets sets_;  // of vertices
  std::unordered_map<std::size_t, bool> taken_back_;
};

}  // namespace pellucid::integrators
