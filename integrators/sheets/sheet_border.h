// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where a sheet ends or is torn: on the way between two places, the last point of it on either
// side.

#include <array>
#include <optional>
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

/// A SheetGap is where the sheet is interrupted between two places: the last vertices before and
/// after it, in the places' order. Where particles are not there at the end there is none.
using SheetGap = std::array<std::optional<SheetVertex>, 2>;

/// Returns the gap between two vertices, by halving the way: between one that is there and one that
/// is not; or between two that are there, where the sheet jumps by more than `tolerance`, world
/// units, however near their places are to each other. Nothing where it does not.
std::optional<SheetGap> gap_between(SheetParticles& particles, const SheetDomain& domain,
                                    const SheetVertex& from, const SheetVertex& to,
                                    double tolerance);

/// A FacetPart is a part of a facet on one side of a gap, around it: corners that are there, one or
/// two, between the gap's two ends on the facet's sides.
struct FacetPart {
  std::vector<const SheetVertex*> corners;
  const SheetVertex *first, *last;  // before and after them
};

/// Returns how far the sheet is from a part's sides, at their middles, and the gap's own edge from
/// the straight one between both ends, at most; world units. `across` lies on the gap's other side.
double deviation_of(SheetParticles& particles, const SheetDomain& domain, const FacetPart& part,
                    const SheetVertex& across, double tolerance);

/// Returns the vertex in the middle of one or two.
SheetVertex middle_of(SheetParticles& particles, const SheetDomain& domain,
                      const std::vector<const SheetVertex*>& corners);

}  // namespace pellucid::integrators
