// SPDX-License-Identifier: GPL-3.0-or-later
// Coefficients: Hairer, Nørsett, Wanner, "Solving Ordinary Differential Equations I", 2nd ed. 1993:
// RK4 table II.1.2, Dormand-Prince 5(4) table II.5.2 (error = b - b̂), its continuous extension
// (6.12) in the form of the program DOPRI5 (weights d_i of CONTD5).
#include "integrators/paths/butcher_tableau.h"

namespace pellucid::integrators {
namespace {

constexpr ButcherTableau euler = {
    .name = "euler",
    .title = "Euler",
    .citation = "Euler 1768, Institutionum calculi integralis",
    .order = 1,
    .stages = 1,
    .b = {1},
};

constexpr ButcherTableau rk4 = {
    .name = "rk4",
    .title = "Runge-Kutta of order 4",
    .citation = "Kutta 1901, Zeitschrift für Mathematik und Physik 46",
    .order = 4,
    .stages = 4,
    .a = {{{}, {0.5}, {0, 0.5}, {0, 0, 1}}},
    .b = {1. / 6, 1. / 3, 1. / 3, 1. / 6},
    .c = {0, 0.5, 0.5, 1},
};

constexpr ButcherTableau dormand_prince = {
    .name = "dopri5",
    .title = "Dormand-Prince 5(4) with PI step size control and dense output",
    .citation = "Dormand & Prince 1980, Journal of Computational and Applied Mathematics 6(1)",
    .order = 5,
    .stages = 6,
    .a = {{{},
           {1. / 5},
           {3. / 40, 9. / 40},
           {44. / 45, -56. / 15, 32. / 9},
           {19372. / 6561, -25360. / 2187, 64448. / 6561, -212. / 729},
           {9017. / 3168, -355. / 33, 46732. / 5247, 49. / 176, -5103. / 18656}}},
    .b = {35. / 384, 0, 500. / 1113, 125. / 192, -2187. / 6784, 11. / 84},
    .c = {0, 1. / 5, 3. / 10, 4. / 5, 8. / 9, 1},
    .adaptive = true,
    .error = {71. / 57600, 0, -71. / 16695, 71. / 1920, -17253. / 339200, 22. / 525, -1. / 40},
    .dense = {-12715105075. / 11282082432, 0, 87487479700. / 32700410799,
              -10690763975. / 1880347072, 701980252875. / 199316789632, -1453857185. / 822651844,
              69997945. / 29380423},
};

constexpr ButcherTableau table[] = {euler, rk4, dormand_prince};

}  // namespace

std::span<const ButcherTableau> steppers() { return table; }

const ButcherTableau& dopri5() { return dormand_prince; }

}  // namespace pellucid::integrators
