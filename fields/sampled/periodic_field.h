// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "fields/field.h"

namespace pellucid::fields {

/// A Repeat says where a field's first period begins along an axis and how long it is, in world
/// units.
struct Repeat {
  double first = 0, period = 0;
};

/// Makes a field that repeats `field` along the axes that have a Repeat, for ever: positions are
/// not folded back, so that a particle's coordinate counts its whole turns. `field` has a velocity
/// in all of [first, first + period].
std::unique_ptr<VectorField> make_periodic_field(std::unique_ptr<VectorField> field,
                                                 const std::array<std::optional<Repeat>, 3>& along);

}  // namespace pellucid::fields
