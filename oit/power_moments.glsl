// Optical depth in front of a depth from power moments, for GLSL and, through GLM, for C++:
// Muenstermann, Krumpen, Klein and Peters 2018.
//
// Of all distributions on the line with the given moments, the canonical one with mass at z holds
// most mass at z. Its other points are the roots in t of the kernel K(t, z) = sum p_k(t) p_k(z)/D_k
// of the orthogonal polynomials p_k, whose squared norms are D_k, and a point t has the mass
// 1 / K(t, t). What lies in front of z is the mass of the points before it, and of z itself the
// share `overestimation`. The polynomials come from the LDL factors of the Hankel matrix of the
// moments: p_1 = t - b_1, p_2 = t^2 - b_2 - l_21 p_1, …

// A root far from [-1, 1] has no mass; held here, infinity cannot make a NaN of it.
float held_root(float t) { return clamp(t, -1e3f, 1e3f); }

// Rounding may turn the smallest norms negative.
float held_norm(float d) { return max(d, 1e-10f); }

float mass_before(float t, float z, float kernel) { return t < z ? 1.0f / kernel : 0.0f; }

// b: moments 1 to 4 of a distribution of mass 1 on [-1, 1].
float mass_in_front_4(vec4 b, float z, float overestimation) {
  float d1 = held_norm(b.y - b.x * b.x);
  float l21 = (b.z - b.x * b.y) / d1;
  float d2 = held_norm(b.w - b.y * b.y - l21 * l21 * d1);
  float p1 = z - b.x, p2 = z * z - b.y - l21 * p1;
  // The kernel as a polynomial in t: k2 t^2 + k1 t + k0.
  float k2 = p2 / d2;
  float k1 = p1 / d1 - l21 * k2;
  float k0 = 1.0f - b.x * p1 / d1 + (l21 * b.x - b.y) * k2;
  float q = -0.5f * (k1 + (k1 < 0.0f ? -1.0f : 1.0f) * sqrt(max(k1 * k1 - 4.0f * k2 * k0, 0.0f)));
  vec2 roots = vec2(held_root(q / k2), held_root(k0 / q));
  float mass = overestimation / (1.0f + p1 * p1 / d1 + p2 * p2 / d2);
  for (int i = 0; i < 2; ++i) {
    float t = roots[i], t1 = t - b.x, t2 = t * t - b.y - l21 * t1;
    mass += mass_before(t, z, 1.0f + t1 * t1 / d1 + t2 * t2 / d2);
  }
  return mass;
}

// The roots of k3 t^3 + k2 t^2 + k1 t + k0, all of them real.
vec3 cubic_roots(float k3, float k2, float k1, float k0) {
  float a = k2 / (3.0f * k3), b = k1 / (3.0f * k3), c = k0 / k3;
  float p = max(a * a - b, 0.0f);  // t = s - a; s^3 - 3 p s + q = 0
  float q = 2.0f * a * a * a - 3.0f * a * b + c;
  float angle = acos(clamp(-0.5f * q / max(p * sqrt(p), 1e-30f), -1.0f, 1.0f)) / 3.0f;
  const float third = 2.09439510239319549f;  // of a turn
  return 2.0f * sqrt(p) * vec3(cos(angle), cos(angle - third), cos(angle + third)) - a;
}

// b: moments 1 to 4, c: moments 5 and 6.
float mass_in_front_6(vec4 b, vec2 c, float z, float overestimation) {
  float d1 = held_norm(b.y - b.x * b.x);
  float l21 = (b.z - b.x * b.y) / d1;
  float l31 = (b.w - b.x * b.z) / d1;
  float d2 = held_norm(b.w - b.y * b.y - l21 * l21 * d1);
  float l32 = (c.x - b.y * b.z - l21 * l31 * d1) / d2;
  float d3 = held_norm(c.y - b.z * b.z - l31 * l31 * d1 - l32 * l32 * d2);
  float p1 = z - b.x, p2 = z * z - b.y - l21 * p1, p3 = z * z * z - b.z - l31 * p1 - l32 * p2;
  float e1 = p1 / d1, e2 = p2 / d2, e3 = p3 / d3;
  float r = l21 * b.x - b.y;  // p_2 at 0
  vec3 roots = cubic_roots(
      e3, e2 - l32 * e3, e1 - l21 * e2 + (l32 * l21 - l31) * e3,
      1.0f - b.x * e1 + r * e2 + (l31 * b.x - b.z - l32 * r) * e3);
  float mass = overestimation / (1.0f + p1 * e1 + p2 * e2 + p3 * e3);
  for (int i = 0; i < 3; ++i) {
    float t = held_root(roots[i]);
    float t1 = t - b.x, t2 = t * t - b.y - l21 * t1, t3 = t * t * t - b.z - l31 * t1 - l32 * t2;
    mass += mass_before(t, z, 1.0f + t1 * t1 / d1 + t2 * t2 / d2 + t3 * t3 / d3);
  }
  return mass;
}
