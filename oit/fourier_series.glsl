// A Fourier series of Dirac impulses and its integral, for GLSL and, through GLM, for C++.
// The includer defines FOURIER_BANDS. Coefficients: c[0] = a_0, c[2k-1] = a_k, c[2k] = b_k.
// Equation numbers: Baeza Rojo et al. 2019.

#define FOURIER_COEFFICIENTS (2 * FOURIER_BANDS + 1)

const float TWO_PI = 6.28318530717958648f;

// exp(i (x + y)) from exp(i x) and exp(i y), as (cos, sin): one sine and cosine serve all bands.
vec2 add_angles(vec2 x, vec2 y) {
  return vec2(x.x * y.x - x.y * y.y, x.y * y.x + x.x * y.y);
}

// Eq. 8 (and 16, 17 with f = -ln(1 - alpha)): what an impulse f at d adds to the coefficients.
void fourier_project(float f, float d, out float c[FOURIER_COEFFICIENTS]) {
  vec2 step = vec2(cos(TWO_PI * d), sin(TWO_PI * d));
  vec2 wave = step;
  c[0] = 2.0f * f;
  for (int k = 1; k <= FOURIER_BANDS; ++k) {
    c[2 * k - 1] = 2.0f * f * wave.x;
    c[2 * k] = 2.0f * f * wave.y;
    wave = add_angles(wave, step);
  }
}

// Eq. 5: the integral from 0 to d.
float fourier_integral(float d, const float c[FOURIER_COEFFICIENTS]) {
  vec2 step = vec2(cos(TWO_PI * d), sin(TWO_PI * d));
  vec2 wave = step;
  float sum = 0.0f;
  for (int k = 1; k <= FOURIER_BANDS; ++k) {
    sum += (c[2 * k - 1] * wave.y + c[2 * k] * (1.0f - wave.x)) / float(k);
    wave = add_angles(wave, step);
  }
  return 0.5f * c[0] * d + sum / TWO_PI;
}
