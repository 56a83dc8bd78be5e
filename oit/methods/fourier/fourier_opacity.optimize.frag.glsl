// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/shapes/fragment.glsl"
#include "oit/shapes/element.glsl"
#include "oit/opacity/element_opacity.glsl"
#include "oit/opacity/importance_series.glsl"

void main() {
  Fragment f = fragment();
  int e = element();
  if (e < 0) discard;
  lower_opacity(e, opacity_by_series(importance(), f.depth));
}
