#include "fragment.glsl"
#include "optical_depth.glsl"

uniform float clamp_alpha;

layout(location = 0) out float total;    // sum of tau
layout(location = 1) out vec4 moments;   // sums of tau z, tau z^2, tau z^3, tau z^4
#if MOMENTS == 6
layout(location = 2) out vec2 more;  // sums of tau z^5, tau z^6
#endif

void main() {
  Fragment f = fragment();
  float z = 2.0 * f.depth - 1.0, z2 = z * z;
  total = optical_depth(min(f.alpha, clamp_alpha));
  moments = total * vec4(z, z2, z2 * z, z2 * z2);
#if MOMENTS == 6
  more = total * z2 * z2 * vec2(z, z2);
#endif
}
