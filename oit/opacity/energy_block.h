// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "oit/gl/gl_objects.h"
#include "scene/opacity_energy.h"

namespace pellucid::oit {

/// The uniform block of energy.glsl.
struct EnergyBlock {
  glm::vec4 weights;  // p, q, r, lambda
  float margin = 0;
  float own_share = 1;
  glm::vec2 unused{0};

  explicit EnergyBlock(const scene::EnergyWeights& w) : weights(w.p, w.q, w.r, w.lambda) {}
  Buffer buffer(const Gl& gl) const { return {gl, std::vector<EnergyBlock>{*this}}; }
};
static_assert(sizeof(EnergyBlock) == 32);

}  // namespace pellucid::oit
