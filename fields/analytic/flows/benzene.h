// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The electrostatic field of a benzene molecule, as point charges on its atoms: six carbons on a
// ring of radius 1.39 Å with charge -q, six hydrogens at 2.48 Å with +q (bond lengths C-C 1.39 Å,
// C-H 1.09 Å; q = 0.115 e as in the OPLS force field, W. L. Jorgensen et al., J. Am. Chem. Soc. 118
// (1996)). It stands in for the potential field of Zöckler, Stalling, Hege, "Interactive
// visualization of 3D-vector fields using illuminated stream lines" (IEEE Visualization 1996).
//
//   E(x) = Σ q_i (x - x_i) / (|x - x_i|² + s²)^(3/2)
//
// is the gradient of a potential, hence free of curl; the softening s keeps it finite at the atoms.

#include <array>

#include "fields/analytic/analytic_field.h"

namespace pellucid::fields::flow {

/// BenzeneOptions are the constants of the field `benzene`.
struct BenzeneOptions {
  double q = 0.115;   // e: charge of a hydrogen
  double soft = 0.1;  // Å: softening at the atoms
};

/// A Benzene is the field `benzene`: electrostatic field of benzene.
struct Benzene {
  using Options = BenzeneOptions;
  static constexpr FlowFacts facts{
      .name = "benzene",
      .title = "Electrostatic field of benzene",
      .citation = "point charges: OPLS, Jorgensen et al., J. Am. Chem. Soc. 118 (1996)",
      .formula = "sum of q_i (x - x_i) / (|x - x_i|^2 + soft^2)^(3/2) over 6 C and 6 H",
      .region = {Vec3(-4, -4, -3), Vec3(4, 4, 3)},
  };
  static const OptionTable<Options>& options() {
    static const OptionTable<Options> table{
        number("q", &Options::q, {.unit = "e", .help = "charge of a hydrogen"}),
        number("soft", &Options::soft,
               {.min = 1e-6, .unit = "Å", .help = "softening at the atoms"})};
    return table;
  }

  /// An Atom is a point charge of the molecule.
  struct Atom {
    double x, y, charge;
  };
  std::array<Atom, 12> atoms;
  double soft2;

  explicit Benzene(const BenzeneOptions& given) : soft2(given.soft * given.soft) {
    for (std::size_t i = 0; i < 6; ++i) {
      const double angle = pi / 3 * double(i);
      atoms[i] = {1.39 * cos(angle), 1.39 * sin(angle), -given.q};
      atoms[i + 6] = {2.48 * cos(angle), 2.48 * sin(angle), given.q};
    }
  }

  template <class T>
  Triple<T> operator()(const Triple<T>& p, double) const {
    Triple<T> sum{T(0), T(0), T(0)};
    for (const Atom& atom : atoms) {
      const T x = p.x - atom.x, y = p.y - atom.y;
      const T d2 = x * x + y * y + p.z * p.z + soft2;
      const T weight = atom.charge / (d2 * sqrt(d2));
      sum.x = sum.x + weight * x;
      sum.y = sum.y + weight * y;
      sum.z = sum.z + weight * p.z;
    }
    return sum;
  }
};

}  // namespace pellucid::fields::flow
