// SPDX-License-Identifier: GPL-3.0-or-later
// What fragment.glsl declares for programs with the define OPTIMIZED_FRAGMENTS; appended to them.
#include "oit/opacity/importance_series.glsl"

float optimized_opacity(vec2 importance, float depth) {
  return opacity_by_series(importance, depth);
}
