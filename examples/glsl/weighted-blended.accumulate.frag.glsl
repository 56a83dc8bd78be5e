// SPDX-License-Identifier: GPL-3.0-or-later
// Eq. 7. The depths that it was made for are 0.1 to 500.
float weight(float d) {
  float z = 0.1 + (500.0 - 0.1) * d;
  return clamp(10.0 / (1e-5 + pow(z / 5.0, 2.0) + pow(z / 200.0, 6.0)), 1e-2, 3e3);
}

void main() {
  Fragment f = fragment();
  sums = vec4(f.alpha * f.color, f.alpha) * f.alpha * weight(f.depth);
  transmittance = f.alpha;  // blended into the product of 1 - alpha
}
