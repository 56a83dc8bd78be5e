// SPDX-License-Identifier: GPL-3.0-or-later
// Where a polynomial on [0, 1] changes its sign, 0 counting as positive. It has Bernstein's
// coefficients b[0] … b[n], n at most MOST_ROOTS. In double; all that decides is `precise`.
const int MOST_ROOTS = 3 * MOST_DEGREE;

bool signs_differ(double a, double b) { return (a < 0.0lf) != (b < 0.0lf); }

// De Casteljau's scheme. At 0 and 1 it returns b[0] and b[n] as they are.
double value_at(double b[MOST_ROOTS + 1], int n, double u) {
  precise double rest = 1.0lf - u;
  for (int round = n; round > 0; --round)
    for (int i = 0; i < round; ++i) {
      precise double mixed = rest * b[i] + u * b[i + 1];
      b[i] = mixed;
    }
  return b[0];
}

// The one sign change between `low` and `high`, by false position as the Illinois algorithm has it
// (Dowell and Jarratt 1971), to 1e-14 of the interval [0, 1].
double bracketed(double b[MOST_ROOTS + 1], int n, double low, double high, double at_low,
                 double at_high) {
  if (at_low == 0.0lf) return low;
  if (at_high == 0.0lf) return high;
  int kept = 0;  // which end stayed in the last step
  for (int i = 0; i < 100 && high - low > 1e-14lf; ++i) {
    precise double u = low + (high - low) * (at_low / (at_low - at_high));
    if (!(low < u && u < high)) u = 0.5lf * (low + high);
    if (!(low < u && u < high)) break;
    double at = value_at(b, n, u);
    if (at == 0.0lf) return u;
    if (signs_differ(at, at_low)) {
      high = u;
      at_high = at;
      if (kept == -1) at_low *= 0.5lf;
      kept = -1;
    } else {
      low = u;
      at_low = at;
      if (kept == 1) at_high *= 0.5lf;
      kept = 1;
    }
  }
  precise double middle = 0.5lf * (low + high);
  return middle;
}

#if MOST_DEGREE == 1
// The `which`-th sign change of a cubic, from 0 on; below 0: there is none. Between the zeros of its
// derivative it is monotonous.
double sign_change(double b[MOST_ROOTS + 1], int n, int which) {
  // The derivative is 3 (d0 (1 - u)² + 2 d1 u (1 - u) + d2 u²) = 3 (a u² + 2 h u + d0).
  double d0 = b[1] - b[0], d1 = b[2] - b[1], d2 = b[3] - b[2];
  double h = d1 - d0, a = d0 - 2.0lf * d1 + d2;
  double inner = sqrt(max(h * h - a * d0, 0.0lf));
  double q = h < 0.0lf ? inner - h : -(inner + h);
  double x = q / a, y = d0 / q;
  x = x > 0.0lf ? min(x, 1.0lf) : 0.0lf;  // also of what is not a number
  y = y > 0.0lf ? min(y, 1.0lf) : 0.0lf;
  double ends[4] = double[](0.0lf, min(x, y), max(x, y), 1.0lf);
  double at[4] = double[](b[0], value_at(b, 3, ends[1]), value_at(b, 3, ends[2]), b[3]);
  int seen = 0;
  double low = -1.0lf, high = -1.0lf, at_low = 0.0lf, at_high = 0.0lf;
  for (int i = 0; i < 3; ++i)
    if (signs_differ(at[i], at[i + 1])) {
      if (seen == which) {
        low = ends[i];
        high = ends[i + 1];
        at_low = at[i];
        at_high = at[i + 1];
      }
      ++seen;
    }
  return bracketed(b, n, low, high, at_low, at_high);
}
#else
// The `which`-th sign change, from 0 on; below 0: there is none. The polynomial has at most as many as
// its coefficients (Descartes' rule). Where these have more than one, the zeros of each derivative
// part [0, 1] into stretches in which the one below is monotonous.
double sign_change(double b[MOST_ROOTS + 1], int n, int which) {
  int changes = 0;
  for (int i = 0; i < n; ++i) changes += int(signs_differ(b[i], b[i + 1]));
  if (changes <= which) return -1.0lf;
  if (changes == 1) return bracketed(b, n, 0.0lf, 1.0lf, b[0], b[n]);
  double roots[MOST_ROOTS + 1];
  int count = 0;
  for (int degree = 1; degree <= n; ++degree) {
    double q[MOST_ROOTS + 1] = b;  // the derivative of that degree, but for a factor
    for (int round = n; round > degree; --round)
      for (int i = 0; i < round; ++i) q[i] = q[i + 1] - q[i];
    double found[MOST_ROOTS + 1];
    int more = 0;
    double left = 0.0lf, at_left = q[0];
    for (int i = 0; i <= count; ++i) {
      double right = i < count ? roots[i] : 1.0lf;
      double at_right = i < count ? value_at(q, degree, right) : q[degree];
      if (signs_differ(at_left, at_right)) {
        found[more] = bracketed(q, degree, left, right, at_left, at_right);
        ++more;
      }
      left = right;
      at_left = at_right;
    }
    roots = found;
    count = more;
  }
  return which < count ? roots[which] : -1.0lf;
}
#endif
