// SPDX-License-Identifier: GPL-3.0-or-later
// Opacities of elements (see scene/elements/elements.h): the least of their fragments'.
#include "oit/gl/bindings.glsl"

// The bits of a float.
layout(binding = element_opacities_image, r32ui) coherent uniform uimageBuffer element_opacities;

// Bits of floats >= 0 compare as they do. An opacity only falls, so that a fragment that does not lie
// below what a load has found lowers nothing: most need no atomic, whose pixels llvmpipe takes one by
// one.
void lower_opacity(int element, float opacity) {
  uint bits = floatBitsToUint(opacity);
  if (bits < imageLoad(element_opacities, element).r)
    imageAtomicMin(element_opacities, element, bits);
}
