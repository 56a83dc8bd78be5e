// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef ENERGY
#define ENERGY
#include "oit/gl/bindings.glsl"
#include "oit/opacity/opacity_energy.glsl"

// Of energy_block.h.
layout(binding = energy_block, std140) uniform Energy {
  vec4 energy_weights;      // p, q, r, lambda
  float importance_margin;  // of a series' period on either side of [0, 1]
  float own_share;          // of a fragment's own step that a series has at its depth
};
#endif
