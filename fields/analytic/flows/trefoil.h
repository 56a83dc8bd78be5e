// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A magnetic flux rope knotted as a trefoil. Its axis is that of the n-foil knots of S.
// Candelaresi, A. Brandenburg, "Decay of helical and nonhelical magnetic knots", Phys. Rev. E 84,
// 016406 (2011), with n = 3:
//   X(s) = ((C + sin ns) sin (n-1)s, (C + sin ns) cos (n-1)s, D cos ns), s in [0, 2π].
//
// The field is a smooth flux tube of unit flux and radius ε around that axis and, where twist ≠ 0,
// the field of a current along it, which winds the field lines around the tube:
//   B = (along + twist around) / 4π, the sums of filament.h.

#include "fields/analytic/analytic_field.h"
#include "fields/analytic/flows/filament.h"

namespace pellucid::fields::flow {

/// TrefoilOptions are the constants of the field `trefoil`.
struct TrefoilOptions {
  double C = 1.6;    // world units: ring's radius
  double D = 1;      // world units: height of the crossings
  double eps = 0.4;  // world units: tube's radius
  double twist = 1;  // 1/world unit: current
};

/// A Trefoil is the field `trefoil`: magnetic trefoil knot.
struct Trefoil {
  using Options = TrefoilOptions;
  static constexpr FlowFacts facts{
      .name = "trefoil",
      .title = "Magnetic trefoil knot",
      .citation = "axis: Candelaresi, Brandenburg, Phys. Rev. E 84 (2011)",
      .formula =
          "flux tube around ((C + sin 3s) sin 2s, (C + sin 3s) cos 2s, D cos 3s), "
          "twisted by a current along it",
      .divergence_free = true,
      .region = {Vec3(-3.5, -3.5, -2), Vec3(3.5, 3.5, 2)},
  };
  static const OptionTable<Options>& options() {
    static const OptionTable<Options> table{
        number("C", &Options::C, {.unit = "world units", .help = "ring's radius"}),
        number("D", &Options::D, {.unit = "world units", .help = "height of the crossings"}),
        number("eps", &Options::eps,
               {.min = 0.3, .max = 10, .unit = "world units", .help = "tube's radius"}),
        number("twist", &Options::twist, {.unit = "1/world unit", .help = "current"})};
    return table;
  }

  std::vector<FilamentElement> axis;
  double eps, twist;

  explicit Trefoil(const TrefoilOptions& given) : eps(given.eps), twist(given.twist) {
    constexpr int count = 192;
    const double C = given.C, D = given.D, ds = 2 * pi / count;
    for (int i = 0; i < count; ++i) {
      const double s = ds * i, r = C + sin(3 * s), slope = 3 * cos(3 * s);
      axis.push_back({{r * sin(2 * s), r * cos(2 * s), D * cos(3 * s)},
                      ds * Vec3(slope * sin(2 * s) + 2 * r * cos(2 * s),
                                slope * cos(2 * s) - 2 * r * sin(2 * s), -3 * D * sin(3 * s))});
    }
  }

  template <class T>
  Triple<T> operator()(const Triple<T>& p, double) const {
    const auto [around, along] = sum_over(axis, p, eps);
    constexpr double unit = 1 / (4 * pi);
    return {unit * (along.x + twist * around.x), unit * (along.y + twist * around.y),
            unit * (along.z + twist * around.z)};
  }
};

}  // namespace pellucid::fields::flow
