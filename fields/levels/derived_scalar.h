// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

#include "fields/levels/level.h"

namespace pellucid::fields {

/// A scalar of a velocity field, computed at the samples of one level: a row of the table.
struct DerivedScalarRow {
  std::string_view name;
  std::string_view title;
  std::string_view citation;
  ScalarLevel (*compute)(const VectorLevel&);
};

std::span<const DerivedScalarRow> derived_scalars();

/// Throws InputError with the nearest names.
const DerivedScalarRow& find_derived_scalar(std::string_view name);

/// The scalar of that name of every level.
std::vector<ScalarLevel> scalars_of(std::span<const VectorLevel> levels, std::string_view name);

}  // namespace pellucid::fields
