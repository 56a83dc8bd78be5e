// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core/vec.h"

namespace pellucid::integrators {

/// A ParticleState is a particle's position, then that of its companion or ∂x/∂s; world units.
using ParticleState = std::array<double, 6>;

/// Returns the particle's position, world units.
inline Vec3 first(const ParticleState& y) { return {y[0], y[1], y[2]}; }
/// Returns the position of its companion, world units, or ∂x/∂s.
inline Vec3 second(const ParticleState& y) { return {y[3], y[4], y[5]}; }

/// A DenseOutput is the state along one step, Σ coefficients[i] θ^i for 0 ≤ θ ≤ 1: Hairer, Nørsett,
/// Wanner, "Solving Ordinary Differential Equations I", 2nd ed. 1993, II.6.
struct DenseOutput {
  std::array<ParticleState, 5> coefficients = {};

  ParticleState state(double theta) const;
  Vec3 position(double theta) const;
  /// Returns dx/dθ, world units.
  Vec3 derivative(double theta) const;
  /// Returns d²x/dθ², world units.
  Vec3 second_derivative(double theta) const;
  /// Returns the length of the way up to θ, world units: Gauss-Legendre with three nodes on each of
  /// 16 pieces, of degree 5 while the speed is smooth. It is not where the particle comes to rest
  /// within a piece, and is slow there.
  double arc_length(double theta) const;
  /// Returns θ up to which the way has this length, at most the whole step's, to the last bit.
  double theta_of_length(double length) const;
};

}  // namespace pellucid::integrators
