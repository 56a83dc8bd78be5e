// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

#include "fields/levels/level.h"

namespace pellucid::fields {

/// A DerivedScalarRow is a scalar of a velocity field, computed at the samples of one level: a row
/// of the table. Velocities are in world units per unit of time, derivatives per world unit.
struct DerivedScalarRow {
  std::string_view name;
  std::string_view title;
  std::string_view citation;
  ScalarLevel (*compute)(const VectorLevel&);
  DoubleLevel (*compute_exactly)(const DoubleVectorLevel&);
};

/// Returns the table of derived scalars.
std::span<const DerivedScalarRow> derived_scalars();

/// Says whether the table has a row of that name.
bool is_derived(std::string_view scalar);

/// Returns the row of that name. Throws InputError with the nearest names when there is none.
const DerivedScalarRow& find_derived_scalar(std::string_view name);

/// Computes the scalar of that name on every level, once blocks of one lattice are joined (see
/// joined_blocks()), so that differences go across their faces. Throws InputError for an unknown
/// name and for a level that check_level() refuses.
///@{
std::vector<ScalarLevel> scalars_of(std::span<const VectorLevel> levels, std::string_view name);
std::vector<DoubleLevel> scalars_of(std::span<const DoubleVectorLevel> levels,
                                    std::string_view name);
///@}

}  // namespace pellucid::fields
