// SPDX-License-Identifier: GPL-3.0-or-later
void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  composite_mean(texelFetch(sums, pixel, 0), 1.0 - texelFetch(transmittance, pixel, 0).r);
}
