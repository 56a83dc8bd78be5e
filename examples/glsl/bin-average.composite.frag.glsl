// SPDX-License-Identifier: GPL-3.0-or-later
// The bins' means, premultiplied, from front to back.
void main() {
  Composite c = nothing;
  for (int bin = 0; bin < bins; ++bin) {
    ivec3 at = ivec3(gl_FragCoord.xy, bin);
    uint count = imageLoad(counts, at).r;
    if (count == 0u) continue;
    vec4 mean = imageLoad(sums, at) / float(count);
    c = over(c, Composite(mean.rgb, 1.0 - mean.a));
  }
  picture = over(c, behind());
}
