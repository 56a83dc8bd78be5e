// The weights of McGuire and Bavoil 2013 without their factor alpha, for GLSL and, through GLM, for
// C++. z: view depth, 0.1 to 500.

float clamped_weight(float w) { return clamp(w, 1e-2f, 3e3f); }

float blended_weight_7(float z) {
  return clamped_weight(10.0f / (1e-5f + pow(z / 5.0f, 2.0f) + pow(z / 200.0f, 6.0f)));
}

float blended_weight_8(float z) {
  return clamped_weight(10.0f / (1e-5f + pow(z / 10.0f, 3.0f) + pow(z / 200.0f, 6.0f)));
}

float blended_weight_9(float z) {
  return clamped_weight(0.03f / (1e-5f + pow(z / 200.0f, 4.0f)));
}

// d in [0, 1].
float blended_weight_10(float d) { return max(1e-2f, 3e3f * pow(1.0f - d, 3.0f)); }

// `equation` 0: no weight. d in [0, 1] is mapped onto the depths that Eqs. 7 to 9 were made for.
float blended_weight(int equation, float alpha, float d) {
  float z = 0.1f + (500.0f - 0.1f) * d;
  if (equation == 7) return alpha * blended_weight_7(z);
  if (equation == 8) return alpha * blended_weight_8(z);
  if (equation == 9) return alpha * blended_weight_9(z);
  if (equation == 10) return alpha * blended_weight_10(d);
  return 1.0f;
}
