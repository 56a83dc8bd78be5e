// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "fields/field.h"

namespace pellucid::fields {

/// Makes a field in which particles go the way back: at time t its velocity is -v(x, 2 start - t).
/// What leaves a place at `start` is after T where it was at start - T.
std::shared_ptr<const VectorField> reversed(std::shared_ptr<const VectorField> field, double start);

/// Returns the `start` of a field that reversed() has made; nothing of another.
std::optional<double> start_of_reversed(const VectorField& field);

/// Returns the field that a reversed one is made of, and any other itself.
const VectorField& unreversed(const VectorField& field);

}  // namespace pellucid::fields
