// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "fields/field.h"

namespace pellucid::scene {

/// A FlowQuantity is what a flow's importance or colour may be by.
enum class FlowQuantity {
  speed,      // |v|
  vorticity,  // |curl v|
  nearness    // minus the distance, Å, to the nearest atom of the field `benzene`
};

/// The quantity at every position, in parallel; 0 where the field has no sample at time 0.
std::vector<double> measure_flow(FlowQuantity quantity, const fields::VectorField& field,
                                 const std::vector<Vec3>& positions);

}  // namespace pellucid::scene
