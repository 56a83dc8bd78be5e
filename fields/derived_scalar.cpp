// Scalars of a sampled velocity. The Q-criterion is that of Li and Chen, Multi-Resolution
// Isosurface Rendering (2023), Eq. 1 (J. C. R. Hunt, A. A. Wray, P. Moin, CTR-S88 (1988)): for a
// flow without divergence, half of |Ω|² - |S|². As there, derivatives inside a level are central
// differences. At the level's faces they are one-sided, (-3f₀ + 4f₁ - f₂)/2h, also of second order:
// the report reads whatever its grid holds beyond its active voxels, which wraps every level in a
// false shell.
#include "fields/derived_scalar.h"

#include <fmt/format.h>

#include "core/names.h"
#include "core/parallel.h"

namespace pellucid {
namespace {

/// Calls compute(j, k, out) for each row of samples, which it fills.
template <class Compute>
ScalarLevel for_each_row(const VectorLevel& v, const Compute& compute) {
  ScalarLevel out{v.origin, v.width, v.size, std::vector<float>(v.samples.size())};
  parallel_for(0, v.size[2], [&](int k) {
    for (int j = 0; j < v.size[1]; ++j) compute(j, k, &out.samples[v.index(0, j, k)]);
  });
  return out;
}

ScalarLevel magnitude(const VectorLevel& v) {
  return for_each_row(v, [&](int j, int k, float* out) {
    for (int i = 0; i < v.size[0]; ++i) out[i] = float(glm::length(Vec3(v.at(i, j, k))));
  });
}

/// Of `count` numbers from `at` on, each the i-th of n along an axis whose samples are `stride`
/// numbers apart: the derivatives along it, times the cell width.
void differences(const float* at, int count, int i, int n, std::ptrdiff_t stride, double* out) {
  const auto f = [&](int m, std::ptrdiff_t step) { return double(at[m + step * stride]); };
  if (i == 0)
    for (int m = 0; m < count; ++m) out[m] = 0.5 * (-3.0 * f(m, 0) + 4.0 * f(m, 1) - f(m, 2));
  else if (i == n - 1)
    for (int m = 0; m < count; ++m) out[m] = 0.5 * (3.0 * f(m, 0) - 4.0 * f(m, -1) + f(m, -2));
  else
    for (int m = 0; m < count; ++m) out[m] = 0.5 * (f(m, 1) - f(m, -1));
}

/// Derivatives are taken of a whole row's numbers, components in turn: loops that vectorize.
ScalarLevel q_criterion(const VectorLevel& v) {
  const int n = v.size[0], numbers = 3 * n;
  const std::ptrdiff_t row = numbers, slice = row * v.size[1];
  const double scale = 1 / (v.width * v.width);
  return for_each_row(v, [&](int j, int k, float* out) {
    thread_local std::vector<double> derivatives;
    derivatives.resize(3 * std::size_t(numbers));
    double *x = derivatives.data(), *y = x + numbers, *z = y + numbers;
    const float* at = &v.at(0, j, k).x;
    differences(at, 3, 0, n, 3, x);
    differences(at + 3, numbers - 6, 1, n, 3, x + 3);
    differences(at + numbers - 3, 3, n - 1, n, 3, x + numbers - 3);
    differences(at, numbers, j, v.size[1], row, y);
    differences(at, numbers, k, v.size[2], slice, z);
    for (int i = 0; i < n; ++i, x += 3, y += 3, z += 3) {
      const double diagonal = x[0] * x[0] + y[1] * y[1] + z[2] * z[2];
      out[i] = float(scale * (-0.5 * diagonal - y[0] * x[1] - z[0] * x[2] - z[1] * y[2]));
    }
  });
}

constexpr DerivedScalarRow rows[] = {
    {"magnitude", "Speed |v|", "Li, Chen 2023, Sect. 3.1", magnitude},
    {"speed", "Speed |v|, by the name that lines give it", "", magnitude},
    {"q", "Q-criterion", "Li, Chen 2023, Eq. 1; Hunt, Wray, Moin 1988", q_criterion}};

}  // namespace

std::span<const DerivedScalarRow> derived_scalars() { return rows; }

const DerivedScalarRow& find_derived_scalar(std::string_view name) {
  return find_row("scalar", name, rows);
}

std::vector<ScalarLevel> scalars_of(std::span<const VectorLevel> levels, std::string_view name) {
  const DerivedScalarRow& row = find_derived_scalar(name);
  std::vector<ScalarLevel> scalars;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    check_level(fmt::format("level {}", i), levels[i]);
    scalars.push_back(row.compute(levels[i]));
  }
  return scalars;
}

}  // namespace pellucid
