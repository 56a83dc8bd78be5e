// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The wake of a hovering rotor: the tip vortices of its blades as helices that are carried down at
// a constant pitch, the rigid wake of vortex theory (J. G. Leishman, Principles of Helicopter
// Aerodynamics, 2nd ed. (2006), Sect. 10.7). Blade k's vortex is the filament
//   (R cos φ, R sin φ, -pitch w / 2π), φ = ωt + 2πk/blades - w, w from 0 (the blade) to 2π turns,
// induced as in filament.h. The wake turns with the rotor: v(x, t) = Q v(Qᵀx, 0), Q the rotation by
// ωt about z. The disc lies in z = 0, the wake below it.

#include "fields/analytic/analytic_field.h"
#include "fields/analytic/flows/filament.h"

namespace pellucid::fields::flow {

/// RotorWakeOptions are the constants of the field `rotor-wake`.
struct RotorWakeOptions {
  int blades = 2;
  double R = 1;        // world units: rotor's radius
  double pitch = 0.5;  // world units: descent per turn
  double turns = 3;    // of the wake, its length
  double gamma = 1;    // world units²/time: circulation of a vortex
  double core = 0.08;  // world units: core radius
  double omega = 1;    // rad/time: rotor's speed
};

/// A RotorWake is the field `rotor-wake`: tip vortices of a hovering rotor.
struct RotorWake {
  using Options = RotorWakeOptions;
  static constexpr FlowFacts facts{
      .name = "rotor-wake",
      .title = "Tip vortices of a hovering rotor",
      .citation = "rigid helical wake: Leishman, Principles of Helicopter Aerodynamics (2006)",
      .formula =
          "Biot-Savart of helices (R cos phi, R sin phi, -pitch w/2pi), "
          "phi = omega t + 2 pi k/blades - w",
      .steady = false,
      .divergence_free = true,
      .region = {Vec3(-1.6, -1.6, -1.6), Vec3(1.6, 1.6, 0.6)},
  };
  static const OptionTable<Options>& options() {
    static const OptionTable<Options> table{
        number("blades", &Options::blades,
               {.min = 1, .max = 8, .unit = "blades", .help = "number of blades"}),
        number("R", &Options::R, {.min = 1e-3, .unit = "world units", .help = "rotor's radius"}),
        number("pitch", &Options::pitch, {.unit = "world units", .help = "descent per turn"}),
        number("turns", &Options::turns,
               {.min = 0.1, .max = 20, .unit = "turns", .help = "length of the wake"}),
        number("gamma", &Options::gamma,
               {.unit = "world units²/time", .help = "circulation of a vortex"}),
        number("core", &Options::core, {.min = 1e-3, .unit = "world units", .help = "core radius"}),
        number("omega", &Options::omega, {.unit = "rad/time", .help = "rotor's speed"})};
    return table;
  }

  std::vector<FilamentElement> wake;  // at time 0
  double core, omega, strength;

  explicit RotorWake(const RotorWakeOptions& given)
      : core(given.core), omega(given.omega), strength(given.gamma / (4 * pi)) {
    constexpr int per_turn = 64;
    const double R = given.R, sink = given.pitch / (2 * pi), step = 2 * pi / per_turn;
    const int count = static_cast<int>(std::ceil(given.turns * per_turn));
    for (int blade = 0; blade < given.blades; ++blade)
      for (int i = 0; i < count; ++i) {
        const double w = step * (i + 0.5), phi = 2 * pi * blade / given.blades - w;
        wake.push_back({{R * cos(phi), R * sin(phi), -sink * w},
                        step * Vec3(R * sin(phi), -R * cos(phi), -sink)});
      }
  }

  template <class T>
  Triple<T> operator()(const Triple<T>& p, double t) const {
    const double c = cos(omega * t), s = sin(omega * t);
    const Triple<T> with_rotor{c * p.x + s * p.y, c * p.y - s * p.x, p.z};
    const Triple<T> v = sum_over(wake, with_rotor, core).around;
    return {strength * (c * v.x - s * v.y), strength * (s * v.x + c * v.y), strength * v.z};
  }
};

}  // namespace pellucid::fields::flow
