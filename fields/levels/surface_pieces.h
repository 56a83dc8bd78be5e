// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fields/levels/level_field.h"

namespace pellucid::fields {

/// A SurfacePiece is a box of space in which a reconstruction is one polynomial over one other, of
/// `degree` along each axis, that takes the surface's value or may do so. Its numbers are
/// Bernstein's coefficients over the box, see BoxPolynomial: of Σ w (f - value), as samples are
/// kept; of Σ w where that is not 1; and of Σ w f of every other scalar, as its samples are kept.
///
/// A piece may also be a face at which the reconstruction jumps: the lower one, across `jump_axis`,
/// of its box, where its numbers are. Those of Σ w (f - value) on the face's other side follow
/// last, over the box as well, and count on the face alone.
struct SurfacePiece {
  Box3 box;  // world
  int degree = 1;
  int jump_axis = -1;       // none: it is the box itself
  bool weighted = false;    // Σ w is not 1 everywhere, and follows
  std::uint64_t first = 0;  // of its numbers

  std::size_t count() const {  // of the numbers of one polynomial
    const auto n = std::size_t(degree) + 1;
    return n * n * n;
  }
};

/// SurfacePieces are all pieces of a surface, and their numbers.
struct SurfacePieces {
  std::vector<SurfacePiece> pieces;
  std::vector<double> numbers;
};

/// Cuts `cells`, of those that surface_cells() finds for the value, into pieces. Boxes have no
/// volume in common, and faces that they share lie at the same coordinates to the last bit. Beside
/// them are the faces at which the reconstruction jumps across the value. `others` are on the same
/// levels, with the same reconstruction.
SurfacePieces surface_pieces(const LevelField& field, double value,
                             std::span<const LatticeCell> cells,
                             std::span<const LevelField* const> others = {});

}  // namespace pellucid::fields
