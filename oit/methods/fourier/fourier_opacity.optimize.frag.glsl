// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/shapes/fragment.glsl"
#include "oit/shapes/element.glsl"
#include "oit/opacity/element_opacity.glsl"
#include "oit/opacity/importance_series.glsl"

void main() {
  Fragment f = fragment();
  lower_opacity(element(), opacity_by_series(importance(), f.depth));
}
