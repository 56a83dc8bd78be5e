// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef OPACITY_ENERGY
#define OPACITY_ENERGY
// The opacity of least energy, Eqs. 2 and 10 of Baeza Rojo et al. 2019, for GLSL and, through GLM,
// for C++: as optimal_opacity() of scene/opacity_energy.h, in float.

// `weights`: p, q, r, lambda. `unimportance`: 1 - g in [0, 1]; what rounding leaves below 0 counts as
// 0. `front` and `behind`: sums of g_j^2 of what lies in front of and behind the fragment; what a
// series makes negative counts as 0.
float optimal_opacity(vec4 weights, float unimportance, float front, float behind) {
  // pow(0, 0) has no value in GLSL; here it is 1.
  float power = weights.w > 0.0f ? pow(max(unimportance, 0.0f), 2.0f * weights.w) : 1.0f;
  float occlusion = power * (weights.z * max(front, 0.0f) + weights.y * max(behind, 0.0f));
  return weights.x / (weights.x + occlusion);
}
#endif
