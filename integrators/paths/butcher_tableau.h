// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <string_view>

namespace pellucid::integrators {

/// An explicit Runge-Kutta scheme as data. k_i = f(t + c_i h, x + h Σ_j a_ij k_j) for the `stages`,
/// x₁ = x + h Σ b_i k_i, and f(x₁) closes the step: it is the next step's first stage, bounds the
/// error (index `stages` of `error`) and shapes the dense output (the same index of `dense`).
struct ButcherTableau {
  static constexpr int max_stages = 6;
  using Row = std::array<double, max_stages>;
  using ClosedRow = std::array<double, max_stages + 1>;

  std::string_view name;
  std::string_view title;
  std::string_view citation;
  int order = 0;
  int stages = 0;
  std::array<Row, max_stages> a{};
  Row b{};
  Row c{};
  bool adaptive = false;  // `error` estimates the step's error, for step size control
  ClosedRow error{};      // weights of h k_i
  ClosedRow dense{};      // weights of the dense output's fourth-degree term; 0: cubic Hermite
};

/// euler, rk4, dopri5.
std::span<const ButcherTableau> steppers();

/// The one of them that is used unless another is asked for.
const ButcherTableau& dopri5();

}  // namespace pellucid::integrators
