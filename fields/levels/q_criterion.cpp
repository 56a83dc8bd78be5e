// SPDX-License-Identifier: GPL-3.0-or-later
// Row by row: the components of a row's samples lie one behind the other, and so do those of its
// neighbours, so that differences along any axis are loops over plain numbers, as wide as the
// machine is.
#include "fields/levels/q_criterion.h"

#include "core/machine/widest.h"
#include "core/parallel.h"

namespace pellucid::fields {
namespace {

/// The first numbers of three rows in line, of which the row at hand is the middle one, or, at a
/// face, the first, and the others follow inwards.
template <class T>
struct Stencil {
  const T* rows[3];
  int face;  // 0: inside; 1: at the low face; -1: at the high one
};

/// A row of samples, whose components are numbers of type T.
template <class T>
struct Row {
  const T* at;        // the first number
  std::size_t count;  // of samples
  Stencil<T> along_y, along_z;
  double scale;  // 1 over the squared width of a cell
};

/// The derivative times the width of a cell, of each of `count` numbers.
template <class T>
[[gnu::always_inline]] inline void differences(const Stencil<T>& f, std::size_t count,
                                               double* __restrict out) {
  const T *a = f.rows[0], *b = f.rows[1], *c = f.rows[2];
  if (f.face == 0)
    for (std::size_t m = 0; m < count; ++m) out[m] = 0.5 * (double(c[m]) - double(a[m]));
  else if (f.face > 0)
    for (std::size_t m = 0; m < count; ++m)
      out[m] = 0.5 * (-3.0 * double(a[m]) + 4.0 * double(b[m]) - double(c[m]));
  else
    for (std::size_t m = 0; m < count; ++m)
      out[m] = 0.5 * (3.0 * double(a[m]) - 4.0 * double(b[m]) + double(c[m]));
}

/// The stencil at place i of n that are `stride` apart, the one at hand at `at`.
template <class T>
[[gnu::always_inline]] inline Stencil<T> stencil(const T* at, int i, int n, std::ptrdiff_t stride) {
  if (i == 0) return {{at, at + stride, at + 2 * stride}, 1};
  if (i == n - 1) return {{at, at - stride, at - 2 * stride}, -1};
  return {{at - stride, at, at + stride}, 0};
}

/// `scratch` has room for nine numbers a sample.
template <class T>
[[gnu::always_inline]] inline void q_of_row(const Row<T>& row, double* __restrict scratch,
                                            T* __restrict out) {
  const std::size_t numbers = 3 * row.count;
  double *x = scratch, *y = x + numbers, *z = y + numbers;
  const int last = int(row.count) - 1;
  differences(stencil(row.at, 0, last + 1, 3), 3, x);
  differences(stencil(row.at + 3, 1, last + 1, 3), numbers - 6, x + 3);
  differences(stencil(row.at + 3 * last, last, last + 1, 3), 3, x + 3 * last);
  differences(row.along_y, numbers, y);
  differences(row.along_z, numbers, z);
  for (std::size_t i = 0; i < row.count; ++i, x += 3, y += 3, z += 3) {
    const double diagonal = x[0] * x[0] + y[1] * y[1] + z[2] * z[2];
    out[i] = T(row.scale * (-0.5 * diagonal - y[0] * x[1] - z[0] * x[2] - z[1] * y[2]));
  }
}

PELLUCID_WIDEST
void compute(const Row<float>& row, double* scratch, float* out) { q_of_row(row, scratch, out); }
PELLUCID_WIDEST
void compute(const Row<double>& row, double* scratch, double* out) { q_of_row(row, scratch, out); }

template <class T>
Level<T> q_of(const Level<glm::vec<3, T>>& v) {
  Level<T> out{v.origin, v.width, v.size, std::vector<T>(v.samples.size())};
  const auto count = std::size_t(v.size[0]);
  const std::ptrdiff_t row = 3 * v.size[0], slice = row * v.size[1];
  parallel_for(0, v.size[2], [&](int k) {
    std::vector<double> scratch(9 * count);
    for (int j = 0; j < v.size[1]; ++j) {
      const T* const at = &v.at(0, j, k).x;
      compute({at, count, stencil(at, j, v.size[1], row), stencil(at, k, v.size[2], slice),
               1 / (v.width * v.width)},
              scratch.data(), &out.samples[v.index(0, j, k)]);
    }
  });
  return out;
}

}  // namespace

ScalarLevel q_criterion(const VectorLevel& velocity) { return q_of(velocity); }
DoubleLevel q_criterion(const DoubleVectorLevel& velocity) { return q_of(velocity); }

}  // namespace pellucid::fields
