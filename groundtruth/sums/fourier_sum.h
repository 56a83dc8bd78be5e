// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

namespace pellucid::groundtruth {

/// A FourierSum is Σ f_i up to a depth d in [0, 1], from a Fourier series of impulses f_i at d_i,
/// in double (equation numbers: Baeza Rojo et al. 2019). It is periodic: an impulse at 0 is one at
/// 1 too.
///
/// Of a single impulse f at d_i, the m-th partial sum is off by at most
///   f / (π (m + 1)) (1 / |sin π(d - d_i)| + 1 / |sin π d_i|)
/// (Abel's summation of Σ_{k>m} sin(kx) / k); at d = d_i it converges to half the step.
class FourierSum {
 public:
  explicit FourierSum(int bands) : a_(std::size_t(bands) + 1), b_(std::size_t(bands) + 1) {}

  /// Adds an impulse f at depth d, Eq. 8.
  void add(double f, double d) {
    for (std::size_t k = 0; k < a_.size(); ++k) {
      a_[k] += 2 * f * std::cos(angle(k, d));
      b_[k] += 2 * f * std::sin(angle(k, d));
    }
  }

  /// Returns the series' integral from 0 to d, Eq. 5.
  double up_to(double d) const {
    double sum = 0.5 * a_[0] * d;
    for (std::size_t k = 1; k < a_.size(); ++k)
      sum += (a_[k] * std::sin(angle(k, d)) + b_[k] * (1 - std::cos(angle(k, d)))) /
             (2 * std::numbers::pi * double(k));
    return sum;
  }

 private:
  static double angle(std::size_t k, double d) { return 2 * std::numbers::pi * double(k) * d; }

  std::vector<double> a_, b_;
};

}  // namespace pellucid::groundtruth
