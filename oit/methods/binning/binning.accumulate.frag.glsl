// SPDX-License-Identifier: GPL-3.0-or-later
// Turns the optical depth of each bin into tau at the bin's far edge.
#include "oit/gl/bindings.glsl"

layout(binding = coefficients_image, r32ui) uniform uimage2DArray bins;

void main() {
  float tau = 0.0;
  for (int bin = 0; bin < BINS; ++bin) {
    ivec3 at = ivec3(gl_FragCoord.xy, bin);
    tau += uintBitsToFloat(imageLoad(bins, at).r);
    imageStore(bins, at, uvec4(floatBitsToUint(tau)));
  }
}
