// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The separated shear flow behind a backward-facing step: a model, not a solution of the equations
// of motion, with the features that a picture of such a flow shows. The step's edge is the origin,
// the lower wall y = -1, the stream goes along x. With a smooth step s(x) = 1 - exp(-x²) and
// η = y + 1 the velocity is the curl of (χ, 0, ψ), hence free of divergence:
//   ψ = U [ ½ (y + δ ln 2cosh(y/δ)) - bubble (x/L) exp(1 - x/L) η² exp(2 - 2η)
//           + roll s(x) exp(-y²/4δ²) cos k(x - Ut/2) ],
//   χ = U rib s(x) exp(-y²/4δ²) sin(βz):
// a shear layer of thickness δ between the stream and slow fluid, a recirculation bubble that
// attaches near x = L, vortices of wavelength 2π/k rolling downstream at half the stream's speed,
// and streamwise ribs of wavelength 2π/β between them.

#include "fields/analytic/analytic_field.h"

namespace pellucid::fields::flow {

/// StepOptions are the constants of the field `step`.
struct StepOptions {
  double U = 1;         // world units/time: speed of the stream
  double delta = 0.2;   // world units: shear layer's thickness
  double bubble = 0.1;  // world units: strength of the recirculation
  double L = 4;         // world units: length of the bubble
  double roll = 0.06;   // world units: strength of rollers
  double k = 3;         // rad/world unit: wave number of rollers
  double rib = 0.04;    // world units: strength of ribs
  double beta = pi;     // rad/world unit: wave number of ribs
};

/// A Step is the field `step`: separated shear flow behind a step.
struct Step : StepOptions {
  using Options = StepOptions;
  static constexpr FlowFacts facts{
      .name = "step",
      .title = "Separated shear flow behind a step",
      .citation = "shear layer, bubble, rollers and ribs as a vector potential; see its source",
      .formula =
          "curl (chi, 0, psi): tanh shear layer + recirculation bubble + travelling rollers "
          "+ streamwise ribs",
      .steady = false,
      .divergence_free = true,
      .region = {Vec3(0, -1, 0), Vec3(12, 2, 6)},
      .bounded = true,
  };
  static const OptionTable<Options>& options() {
    static const OptionTable<Options> table{
        number("U", &Options::U, {.unit = "world units/time", .help = "speed of the stream"}),
        number("delta", &Options::delta,
               {.min = 0.01, .unit = "world units", .help = "shear layer's thickness"}),
        number("bubble", &Options::bubble,
               {.unit = "world units", .help = "strength of the recirculation"}),
        number("L", &Options::L,
               {.min = 0.1, .unit = "world units", .help = "length of the bubble"}),
        number("roll", &Options::roll, {.unit = "world units", .help = "strength of rollers"}),
        number("k", &Options::k, {.unit = "rad/world unit", .help = "wave number of rollers"}),
        number("rib", &Options::rib, {.unit = "world units", .help = "strength of ribs"}),
        number("beta", &Options::beta, {.unit = "rad/world unit", .help = "wave number of ribs"})};
    return table;
  }

  /// (∂ψ/∂y, ∂χ/∂z - ∂ψ/∂x, -∂χ/∂y), term by term.
  template <class T>
  Triple<T> operator()(const Triple<T>& p, double t) const {
    const T growth = 1.0 - exp(-p.x * p.x), growth_dx = 2.0 * p.x * exp(-p.x * p.x);
    const double width2 = 4 * delta * delta;
    const T layer = exp(-p.y * p.y / width2), layer_dy = -2.0 / width2 * p.y * layer;
    const T phase = k * (p.x - 0.5 * U * t);
    const T wave = roll * cos(phase), wave_dx = -k * roll * sin(phase);
    const T eta = p.y + 1.0, s = p.x / L;
    const T along = bubble * s * exp(1.0 - s), along_dx = bubble * (1.0 - s) * exp(1.0 - s) / L;
    const T across = eta * eta * exp(2.0 - 2.0 * eta);
    const T across_dy = 2.0 * eta * (1.0 - eta) * exp(2.0 - 2.0 * eta);
    const T psi_dy = 0.5 * (1.0 + tanh(p.y / delta)) - along * across_dy + growth * layer_dy * wave;
    const T psi_dx = -along_dx * across + layer * (growth_dx * wave + growth * wave_dx);
    const T chi_dz = rib * beta * growth * layer * cos(beta * p.z);
    const T chi_dy = rib * growth * layer_dy * sin(beta * p.z);
    return {U * psi_dy, U * (chi_dz - psi_dx), -U * chi_dy};
  }
};

}  // namespace pellucid::fields::flow
