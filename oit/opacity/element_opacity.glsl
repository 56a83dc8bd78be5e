// SPDX-License-Identifier: GPL-3.0-or-later
// Opacities of elements (see scene/elements/elements.h): the least of their fragments'.
#include "oit/gl/bindings.glsl"

// The bits of a float.
layout(binding = element_opacities_image, r32ui) coherent uniform uimageBuffer element_opacities;

// Bits of floats >= 0 compare as they do.
void lower_opacity(int element, float opacity) {
  imageAtomicMin(element_opacities, element, floatBitsToUint(opacity));
}
