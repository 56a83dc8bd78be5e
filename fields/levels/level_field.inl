// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace pellucid::fields {

/// A lattice coordinate within a cell; BoxPolynomial has one of its own.
template <class T>
const T& on_lattice(const T& s) {
  return s;
}

template <class T>
T LevelField::trilinear(const LatticeCell& cell, const std::array<T, 3>& s, double kept) const {
  const ScalarLevel& level = levels_[cell.level];
  const int i = cell.low[0], j = cell.low[1], k = cell.low[2];
  const std::array<T, 3> r{1.0 - s[0], 1.0 - s[1], 1.0 - s[2]};
  const auto line = [&](int b, int c) -> T {
    const double first = double(level.at(i, j + b, k + c)) - kept;
    const double second = double(level.at(i + 1, j + b, k + c)) - kept;
    return r[0] * T(first) + s[0] * T(second);
  };
  return r[2] * (r[1] * line(0, 0) + s[1] * line(1, 0)) +
         s[2] * (r[1] * line(0, 1) + s[1] * line(1, 1));
}

/// Eqs. 2 and 3: at the place s in [0, 1] of a lattice cell, the hat of the corner at 0 is 1 - s
/// and that of the corner at 1 is s.
template <class T>
void LevelField::add_hats(const LatticeCell& cell, const std::array<T, 3>& s, double kept,
                          LevelSum<T>& out) const {
  if (is_whole(cell)) {
    out.weight = out.weight + T(1.0);
    out.sum = out.sum + trilinear(cell, s, kept);
    return;
  }
  const ScalarLevel& level = levels_[cell.level];
  for (int corner = 0; corner < 8; ++corner) {
    std::array<int, 3> at = cell.low;
    bool inside = true;
    for (int axis = 0; axis < 3; ++axis) {
      at[axis] += corner >> axis & 1;
      inside &= at[axis] >= 0 && at[axis] < level.size[axis];
    }
    if (!inside || covered(cell.level, at)) continue;
    const auto hat = [&](int axis) -> T { return corner >> axis & 1 ? s[axis] : 1.0 - s[axis]; };
    const T weight = hat(0) * hat(1) * hat(2);
    out.weight = out.weight + weight;
    out.sum = out.sum + weight * T(double(level.at(at[0], at[1], at[2])) - kept);
  }
}

template <class T>
LevelSum<T> LevelField::sum(std::span<const LatticeCell> cells, const std::array<T, 3>& x,
                            double value) const {
  const double kept = scale_.kept(value);
  LevelSum<T> out;
  T rest = 1.0;  // of the weight, left to coarser levels
  for (const LatticeCell& cell : cells) {
    const ScalarLevel& level = levels_[cell.level];
    std::array<T, 3> s;
    for (int axis = 0; axis < 3; ++axis)
      s[axis] = on_lattice((x[axis] - level.origin[axis]) / level.width - double(cell.low[axis]));
    if (hat()) {
      add_hats(cell, s, kept, out);
      continue;
    }
    const T f = trilinear(cell, s, kept);
    T fade = 1.0;  // 0 on the level's faces, 1 from the next layer of samples on
    const bool coarsest = &cell == &cells.back();  // nothing is left to fade into
    for (int axis = 0; axis < 3 && !coarsest; ++axis) {
      if (cell.low[axis] == 0) fade = fade * s[axis];
      if (cell.low[axis] == level.size[axis] - 2) fade = fade * (1.0 - s[axis]);
    }
    const T weight = rest * fade;
    out.weight = out.weight + weight;
    out.sum = out.sum + weight * f;
    rest = rest * (1.0 - fade);
  }
  return out;
}

}  // namespace pellucid::fields
