// A Fourier series of Dirac impulses and its integral, for GLSL and, through GLM, for C++.
// Equation numbers: Baeza Rojo et al. 2019. A band's coefficients are the pair (a_k, b_k), k = 0
// included; a wave is (cos, sin) of 2 pi k d.

const float TWO_PI = 6.28318530717958648f;

vec2 fourier_wave(float k, float d) { return vec2(cos(TWO_PI * k * d), sin(TWO_PI * k * d)); }

// exp(i (x + y)) from exp(i x) and exp(i y): one sine and cosine serve all bands.
vec2 add_angles(vec2 x, vec2 y) {
  return vec2(x.x * y.x - x.y * y.y, x.y * y.x + x.x * y.y);
}

// Eq. 8 (and 16, 17 with f = -ln(1 - alpha)): what an impulse f adds to a band's coefficients.
vec2 fourier_project(float f, vec2 wave) { return 2.0f * f * wave; }

// A band's term of Eq. 5, the integral from 0 to d.
float fourier_integral(int k, vec2 coefficients, float d, vec2 wave) {
  if (k == 0) return 0.5f * coefficients.x * d;
  return (coefficients.x * wave.y + coefficients.y * (1.0f - wave.x)) / (TWO_PI * float(k));
}
