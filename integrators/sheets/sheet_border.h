// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The border of a sheet where particles are no more: between one that is there at the end and one
// that is not, the last place whose particle is there.

#include <array>
#include <span>
#include <vector>

#include "integrators/sheets/sheet_particles.h"

namespace pellucid::integrators {

/// A SheetVertex is a particle with its place.
struct SheetVertex {
  Vec3 place{0};
  SheetParticle particle;

  bool is_there() const { return particle.is_there(); }
};

/// Returns the vertex of a place.
SheetVertex vertex_at(SheetParticles& particles, const Vec3& place);

/// Returns the last vertex that is there on the way from one that is there to a place whose
/// particle is not, by halving the way.
SheetVertex border_between(SheetParticles& particles, const SheetDomain& domain,
                           const SheetVertex& there, const Vec3& lost);

/// A BorderFacet is a facet of which one or two corners are there, and what is left of it: those
/// corners and the border's two points, in the facet's own order.
struct BorderFacet {
  std::array<const SheetVertex*, 3> corners;
  std::vector<const SheetVertex*> left;  // three or four; `border` are two next to each other
  std::array<const SheetVertex*, 2> border;
};

/// Returns how far the true border is from the straight one at its middle, and the sheet from the
/// straight sides that end on the border, at most; world units.
double border_deviation(SheetParticles& particles, const SheetDomain& domain,
                        const BorderFacet& facet);

}  // namespace pellucid::integrators
