// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fields/sampled/cell_grid.h"

namespace pellucid::fields {

/// Estimates the largest difference between interpolant and sampled field, in world units per unit
/// of time: half of
/// |(mean Jacobian of the cells around a node - the cell's own there) (node - cell's centre)|.
/// In one dimension with even spacing h that is h²/8 |f''|, the error of straight lines: the
/// Jacobians differ by h f''/2 and the centre is h/2 away. (The gradient recovery of O. C.
/// Zienkiewicz and J. Z. Zhu, Int. J. Numer. Meth. Engng. 24 (1987).) Of constant cells it is the
/// largest |cell's velocity - mean of the cells around a corner|: that of a straight field there.
/// Of more than `most_nodes` nodes as many are looked at, which a lot with a fixed seed picks: what
/// is larger than the result is larger at fewer than one in a thousand nodes, with a certainty of
/// 1 - 0.999^most_nodes.
double cell_sampling_error(const CellGrid& grid, vtkIdType most_nodes = 1 << 14);

}  // namespace pellucid::fields
