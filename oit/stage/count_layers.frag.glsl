// SPDX-License-Identifier: GPL-3.0-or-later
// Layers per pixel.
#include "oit/shapes/fragment.glsl"

layout(location = 0) out float count;

void main() {
  fragment();
  count = 1.0;
}
