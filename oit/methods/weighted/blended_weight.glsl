// SPDX-License-Identifier: GPL-3.0-or-later
// The weights of McGuire and Bavoil 2013 without their factor alpha, for GLSL and, through GLM, for
// C++. z: view depth, 0.1 to 500.

// pow() takes a logarithm and an exponential.
float square(float x) { return x * x; }
float cube(float x) { return x * x * x; }

float clamped_weight(float w) { return clamp(w, 1e-2f, 3e3f); }

float blended_weight_7(float z) {
  return clamped_weight(10.0f / (1e-5f + square(z / 5.0f) + square(cube(z / 200.0f))));
}

float blended_weight_8(float z) {
  return clamped_weight(10.0f / (1e-5f + cube(z / 10.0f) + square(cube(z / 200.0f))));
}

float blended_weight_9(float z) {
  return clamped_weight(0.03f / (1e-5f + square(square(z / 200.0f))));
}

// d in [0, 1].
float blended_weight_10(float d) { return max(1e-2f, 3e3f * cube(1.0f - d)); }

// `equation` 0: no weight. d in [0, 1] is mapped onto the depths that Eqs. 7 to 9 were made for.
float blended_weight(int equation, float alpha, float d) {
  float z = 0.1f + (500.0f - 0.1f) * d;
  if (equation == 7) return alpha * blended_weight_7(z);
  if (equation == 8) return alpha * blended_weight_8(z);
  if (equation == 9) return alpha * blended_weight_9(z);
  if (equation == 10) return alpha * blended_weight_10(d);
  return 1.0f;
}
