// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace pellucid::fields {

// An arithmetic may have either of these in a form of its own, which is found by its namespace.

/// A world coordinate as a lattice coordinate within a cell.
template <class T>
T lattice_coordinate(const T& x, double origin, double width, int low) {
  return (x - origin) / width - double(low);
}

/// Σ f h over the corners of a cell, of which corner i is at 1 along those axes whose bits it has;
/// h, the product of 1 - s or s of each axis, is its hat at the place s in [0, 1].
template <class T>
T trilinear_form(const std::array<T, 3>& s, const std::array<double, 8>& f) {
  const std::array<T, 3> r{1.0 - s[0], 1.0 - s[1], 1.0 - s[2]};
  const auto line = [&](std::size_t i) -> T { return r[0] * T(f[i]) + s[0] * T(f[i + 1]); };
  return r[2] * (r[1] * line(0) + s[1] * line(2)) + s[2] * (r[1] * line(4) + s[1] * line(6));
}

inline std::array<double, 8> LevelField::corners(const LatticeCell& cell, double kept) const {
  const ScalarLevel& level = levels_[cell.level];
  std::array<double, 8> values;
  for (int i = 0; i < 8; ++i)
    values[std::size_t(i)] = double(level.at(cell.low[0] + (i & 1), cell.low[1] + (i >> 1 & 1),
                                             cell.low[2] + (i >> 2))) -
                             kept;
  return values;
}

/// Eqs. 2 and 3: at the place s in [0, 1] of a lattice cell, the hat of the corner at 0 is 1 - s
/// and that of the corner at 1 is s. Those of all corners add up to 1.
template <class T>
void LevelField::add_hats(const LatticeCell& cell, const std::array<T, 3>& s, double kept,
                          LevelSum<T>& out) const {
  const unsigned seen = seen_corners(cell);
  if (seen == all_corners) {
    out.weight = out.weight + T(1.0);
    out.sum = out.sum + trilinear_form(s, corners(cell, kept));
    return;
  }
  if (seen == 0) return;
  const ScalarLevel& level = levels_[cell.level];
  std::array<double, 8> hats{}, values{};
  for (unsigned i = 0; i < 8; ++i) {
    if (!(seen >> i & 1)) continue;
    hats[i] = 1;
    values[i] = double(level.at(cell.low[0] + int(i & 1), cell.low[1] + int(i >> 1 & 1),
                                cell.low[2] + int(i >> 2))) -
                kept;
  }
  out.weight = out.weight + trilinear_form(s, hats);
  out.sum = out.sum + trilinear_form(s, values);
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
    for (std::size_t axis = 0; axis < 3; ++axis)
      s[axis] = lattice_coordinate(x[axis], level.origin[axis], level.width, cell.low[axis]);
    if (hat()) {
      add_hats(cell, s, kept, out);
      continue;
    }
    const T f = trilinear_form(s, corners(cell, kept));
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
