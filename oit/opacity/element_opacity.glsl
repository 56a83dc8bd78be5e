// SPDX-License-Identifier: GPL-3.0-or-later
// Opacities of elements (see scene/elements/elements.h): the least of their fragments'.
layout(binding = 7, r32ui) coherent uniform uimageBuffer element_opacities;  // the bits of a float

// Bits of floats >= 0 compare as they do.
void lower_opacity(int element, float opacity) {
  imageAtomicMin(element_opacities, element, floatBitsToUint(opacity));
}
