// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The pair of leading-edge vortices above a delta wing at an angle of attack: a model, not a
// solution. The vortices are straight filaments of circulation ±Γ from the wing's apex at the
// origin, along (1, ±b, h), in a uniform stream U (cos α, 0, sin α). They are one filament, which
// comes from far downstream on the left, turns at the apex and leaves on the right. Between the two
// the flow goes down, outside it goes up, as above a wing that carries lift.
//
// With r from a straight filament's end, d its direction and h² = |r|² - (r·d)² + ε²,
// Rosenhead's integral over lengths from 0 to L (see filament.h) is closed:
//   v = Γ/4π (d × r)/h² [ (L - r·d)/sqrt((L - r·d)² + h²) + r·d/sqrt((r·d)² + h²) ].
// It is a curl, hence free of divergence.

#include "fields/analytic/analytic_field.h"

namespace pellucid::fields::flow {

/// DeltaWingOptions are the constants of the field `delta-wing`.
struct DeltaWingOptions {
  double U = 1;        // world units/time: speed far away
  double alpha = 15;   // degrees: angle of attack
  double gamma = 1.5;  // world units²/time: circulation
  double b = 0.35;     // spread of the vortices, per length
  double h = 0.12;     // rise, per length
  double core = 0.06;  // world units: core radius
};

/// A DeltaWing is the field `delta-wing`: leading-edge vortex pair of a delta wing.
struct DeltaWing {
  using Options = DeltaWingOptions;
  static constexpr FlowFacts facts{
      .name = "delta-wing",
      .title = "Leading-edge vortex pair of a delta wing",
      .citation = "two straight Rosenhead filaments in a uniform stream; derived in its source",
      .formula = "U (cos alpha, 0, sin alpha) + vortices of circulation +-gamma along (1, +-b, h)",
      .divergence_free = true,
      .region = {Vec3(-0.5, -1.5, -0.5), Vec3(3, 1.5, 1.5)},
  };
  static const OptionTable<Options>& options() {
    static const OptionTable<Options> table{
        number("U", &Options::U, {.unit = "world units/time", .help = "speed far away"}),
        number("alpha", &Options::alpha,
               {.min = -90, .max = 90, .unit = "degrees", .help = "angle of attack"}),
        number("gamma", &Options::gamma, {.unit = "world units²/time", .help = "circulation"}),
        number("b", &Options::b,
               {.min = 0.01, .unit = "1", .help = "spread of the vortices, per length"}),
        number("h", &Options::h, {.unit = "1", .help = "rise, per length"}),
        number("core", &Options::core,
               {.min = 1e-3, .unit = "world units", .help = "core radius"})};
    return table;
  }

  static constexpr double length = 50;  // of the filaments: far beyond the region
  double b, h, core2, strength;
  Vec3 stream;

  explicit DeltaWing(const DeltaWingOptions& given)
      : b(given.b),
        h(given.h),
        core2(given.core * given.core),
        strength(given.gamma / (4 * pi)),
        stream(given.U * Vec3(cos(given.alpha * pi / 180), 0, sin(given.alpha * pi / 180))) {}

  template <class T>
  Triple<T> operator()(const Triple<T>& p, double) const {
    const Triple<T> right = induced(p, b), left = induced(p, -b);
    return {stream.x + right.x - left.x, stream.y + right.y - left.y, stream.z + right.z - left.z};
  }

 private:
  template <class T>
  Triple<T> induced(const Triple<T>& p, double spread) const {
    const Vec3 d = glm::normalize(Vec3(1, spread, h));
    const T s = p.x * d.x + p.y * d.y + p.z * d.z;
    const T h2 = p.x * p.x + p.y * p.y + p.z * p.z - s * s + core2;
    const T rest = length - s;
    const T weight = strength * (rest / sqrt(rest * rest + h2) + s / sqrt(s * s + h2)) / h2;
    return {weight * (d.y * p.z - d.z * p.y), weight * (d.z * p.x - d.x * p.z),
            weight * (d.x * p.y - d.y * p.x)};
  }
};

}  // namespace pellucid::fields::flow
