// SPDX-License-Identifier: GPL-3.0-or-later
// Opacity as optical depth, for GLSL and, through GLM, for C++.

// -ln(1 - alpha). GLSL has no log1p: below 1e-2 a series keeps the digits that 1 - alpha loses
// (its first term left out, alpha^5 / 5, is 2e-9 of the value there).
float optical_depth(float alpha) {
  if (alpha < 0.01f)
    return alpha * (1.0f + alpha * (0.5f + alpha * (1.0f / 3.0f + alpha * 0.25f)));
  return -log(1.0f - alpha);
}

// 1 - exp(-tau), tau >= 0: the inverse, likewise.
float opacity(float tau) {
  if (tau < 0.01f) return tau * (1.0f - tau * (0.5f - tau * (1.0f / 6.0f - tau / 24.0f)));
  return 1.0f - exp(-tau);
}
