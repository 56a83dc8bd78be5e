// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fields/field.h"

namespace pellucid::fuzz {

/// Asks a field for what its users ask: facts, velocities at corners, inside, outside, at NaN.
inline void use(const fields::VectorField& field) {
  const Box3 box = field.domain();
  const auto sampler = field.sampler();
  Vec3 v;
  Mat3 jacobian;
  for (const double s : {0.0, 0.3, 0.999, 1.0, 1.5, std::numeric_limits<double>::quiet_NaN()})
    for (const double t : {0.0, 0.5, 1.0}) {
      const Vec3 x = box.min + (box.max - box.min) * s;
      sampler->velocity(x, t, v);
      sampler->velocity_and_jacobian(x, t, v, jacobian);
    }
  sampler->velocity(Vec3(0.25), 0, v);  // where a field has no bounds
  field.sampling_error();
  field.cell_size();
  field.fills_domain();
  field.time_spacing();
  field.description();
}

}  // namespace pellucid::fuzz
