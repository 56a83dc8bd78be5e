// SPDX-License-Identifier: GPL-3.0-or-later
// Opacities of elements (see scene/elements/elements.h): the least of their fragments'.
#include "oit/gl/bindings.glsl"

// The bits of a float.
layout(binding = element_opacities_image, r32ui) coherent uniform uimageBuffer element_opacities;

// Bits of floats >= 0 compare as they do. Most fragments lower nothing: what is there is never below
// what a load finds, and llvmpipe takes an atomic's pixels one by one.
void lower_opacity(int element, float opacity) {
  uint bits = floatBitsToUint(opacity);
  if (bits < imageLoad(element_opacities, element).r)
    imageAtomicMin(element_opacities, element, bits);
}
