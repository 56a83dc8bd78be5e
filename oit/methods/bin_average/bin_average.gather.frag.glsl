// SPDX-License-Identifier: GPL-3.0-or-later
// Composites the bins of a pass from front to back; blending puts them under the nearer passes'.
#include "oit/methods/bin_average/bins.glsl"
#include "oit/stage/front_to_back.glsl"

layout(location = 0) out vec4 gathered;

void main() {
  Composite c = nothing;
  for (int bin = 0; bin < bins_here; ++bin) {
    vec4 mean = mean_of_bin(ivec3(gl_FragCoord.xy, bin));
    c = over(c, Composite(mean.rgb, 1.0 - mean.a));
  }
  gathered = vec4(c.color, 1.0 - c.transmittance);
}
