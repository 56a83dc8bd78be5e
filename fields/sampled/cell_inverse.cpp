// SPDX-License-Identifier: GPL-3.0-or-later
// The inverse of a cell's map from parametric coordinates p to positions X(p): the least of
// |x - X(p)|, by the method of Levenberg (1944) and Marquardt (1963),
//
//     (JᵀJ + λ tr(JᵀJ)/3) Δp = Jᵀ (x - X(p)),    J = ∂X/∂p,
//
// with J's columns scaled to the same length, so that a thin cell is as good as a cube. λ grows by
// ten where a step does not come nearer and falls by ten where it does: at first the way is safe,
// at last it is Newton's. A singular J, as where points of the cell coincide, bounds a step by λ.
//
// VTK's own iteration is Newton's from the cell's middle alone, and gives up where a determinant is
// small or a step is long: in pyramids, wedges and collapsed hexahedra that are valid. Here further
// starts lie between the middle and the corners.
//
// That x is outside is certain where all points of a cell with straight edges lie on one side of a
// plane through x: the plane along the face beyond which p has come out is tried.

#include "fields/sampled/cell_inverse.h"

#include <vtkCellType.h>
#include <vtkGenericCell.h>

#include <algorithm>
#include <iterator>
#include <vector>

#include "fields/finite.h"
#include "fields/sampled/cell_grid.h"
#include "fields/sampled/dense_field.h"

namespace pellucid::fields {
namespace {

/// Holds p where dot(outward, p) ≤ end.
struct HalfSpace {
  Vec3 outward;
  double end;

  double excess(const Vec3& p) const { return glm::dot(outward, p) - end; }
};
/// Where a cell's parametric coordinates are.
using Domain = std::vector<HalfSpace>;

constexpr HalfSpace cube_sides[] = {{Vec3(-1, 0, 0), 0}, {Vec3(1, 0, 0), 1},  {Vec3(0, -1, 0), 0},
                                    {Vec3(0, 1, 0), 1},  {Vec3(0, 0, -1), 0}, {Vec3(0, 0, 1), 1}};
constexpr HalfSpace tetrahedron_sides[] = {
    {Vec3(-1, 0, 0), 0}, {Vec3(0, -1, 0), 0}, {Vec3(0, 0, -1), 0}, {Vec3(1, 1, 1), 1}};
constexpr HalfSpace wedge_sides[] = {{Vec3(-1, 0, 0), 0},
                                     {Vec3(0, -1, 0), 0},
                                     {Vec3(1, 1, 0), 1},
                                     {Vec3(0, 0, -1), 0},
                                     {Vec3(0, 0, 1), 1}};

/// Of a prism over the polygon of the first half of its corners, which go around once.
Domain prism_sides(vtkGenericCell& cell) {
  const int sides = cell.GetNumberOfPoints() / 2;
  const double* corners = cell.GetParametricCoords();
  Domain domain{{Vec3(0, 0, -1), 0}, {Vec3(0, 0, 1), 1}};
  for (int i = 0; i < sides; ++i) {
    const double *a = corners + 3 * i, *b = corners + 3 * ((i + 1) % sides),
                 *inner = corners + 3 * ((i + 2) % sides);
    HalfSpace side{Vec3(b[1] - a[1], a[0] - b[0], 0), 0};
    side.end = glm::dot(side.outward, Vec3(a[0], a[1], 0));
    if (side.excess(Vec3(inner[0], inner[1], 0)) > 0) side = {-side.outward, -side.end};
    domain.push_back(side);
  }
  return domain;
}

Domain domain_of(vtkGenericCell& cell) {
  switch (cell.GetCellType()) {
    case VTK_TETRA:
    case VTK_QUADRATIC_TETRA:
      return {std::begin(tetrahedron_sides), std::end(tetrahedron_sides)};
    case VTK_WEDGE:
    case VTK_QUADRATIC_WEDGE:
    case VTK_QUADRATIC_LINEAR_WEDGE:
    case VTK_BIQUADRATIC_QUADRATIC_WEDGE:
      return {std::begin(wedge_sides), std::end(wedge_sides)};
    case VTK_PENTAGONAL_PRISM:
    case VTK_HEXAGONAL_PRISM:
      return prism_sides(cell);
    default:
      // A pyramid's, too, whose last face is its apex.
      return {std::begin(cube_sides), std::end(cube_sides)};
  }
}

/// The nearest p within, or nearly so, by going back through one face after another.
Vec3 back_within(const Domain& domain, Vec3 p) {
  constexpr int rounds = 8;
  for (int round = 0; round < rounds; ++round)
    for (const HalfSpace& side : domain)
      if (const double excess = side.excess(p); excess > 0)
        p -= excess / glm::dot(side.outward, side.outward) * side.outward;
  return p;
}

class CellInverse {
 public:
  CellInverse(vtkGenericCell& cell, const Vec3& x) : cell_(cell), count_(cell.GetNumberOfPoints()) {
    Box3 box;
    for (int i = 0; i < count_; ++i) {
      double point[3];
      cell.GetPoints()->GetPoint(i, point);
      box.extend({point[0], point[1], point[2]});
      arms_[i] = Vec3(point[0], point[1], point[2]) - x;
    }
    diagonal_ = box.diagonal();
    const Vec3 slack(accepted());
    is_near_ = diagonal_ > 0 && Box3{box.min - slack, box.max + slack}.contains(x);
  }

  std::optional<Vec3> place() {
    if (!is_near_) return std::nullopt;
    const Domain domain = domain_of(cell_);
    for (const Vec3& start : starts()) {
      const Vec3 p = nearest(start), inside = back_within(domain, p);
      if (glm::length(miss(inside)) <= accepted()) return inside;
      if (cell_.IsLinear() && is_apart(domain, p, inside)) return std::nullopt;
    }
    return std::nullopt;
  }

 private:
  double accepted() const { return edge_rounding * diagonal_; }

  std::vector<Vec3> starts() {
    double middle[3];
    cell_.GetParametricCenter(middle);
    const Vec3 center(middle[0], middle[1], middle[2]);
    std::vector<Vec3> starts{center};
    const double* corners = cell_.GetParametricCoords();
    for (int i = 0; i < std::min(count_, 8); ++i)
      starts.push_back(0.5 *
                       (center + Vec3(corners[3 * i], corners[3 * i + 1], corners[3 * i + 2])));
    return starts;
  }

  /// x - X(p), of differences to x: so that a cell far from the origin loses no digits.
  Vec3 miss(const Vec3& p) {
    double weights[CellGrid::largest_cell];
    cell_.InterpolateFunctions(&p.x, weights);
    Vec3 sum(0);
    for (int i = 0; i < count_; ++i) sum -= weights[i] * arms_[i];
    return sum;
  }

  Mat3 slopes(const Vec3& p) {
    double derivatives[3 * CellGrid::largest_cell];
    cell_.InterpolateDerivs(&p.x, derivatives);
    Mat3 sum(0);
    for (int axis = 0; axis < 3; ++axis)
      for (int i = 0; i < count_; ++i) sum[axis] += derivatives[axis * count_ + i] * arms_[i];
    return sum;
  }

  Vec3 step(const Mat3& slopes, const Vec3& miss, double damping) const {
    Vec3 scale;
    Mat3 scaled;
    for (int axis = 0; axis < 3; ++axis) {
      scale[axis] = 1 / std::max(glm::length(slopes[axis]), 1e-9 * diagonal_);
      scaled[axis] = slopes[axis] * scale[axis];
    }
    const Mat3 squared = glm::transpose(scaled) * scaled;
    const double trace = squared[0][0] + squared[1][1] + squared[2][2];
    const Mat3 damped = squared + Mat3(damping * trace / 3);
    return glm::inverse(damped) * (glm::transpose(scaled) * miss) * scale;
  }

  Vec3 nearest(Vec3 p) {
    constexpr int most_steps = 60;
    constexpr double first_damping = 1e-6, most_damping = 1e6, close = 1e-14;
    double damping = first_damping;
    Vec3 left = miss(p);
    for (int i = 0; i < most_steps && damping < most_damping; ++i) {
      if (glm::length(left) <= close * diagonal_) break;
      const Vec3 next = glm::clamp(p + step(slopes(p), left, damping), Vec3(-1), Vec3(2));
      const Vec3 left_then = miss(next);
      const bool is_nearer = glm::length(left_then) < glm::length(left);  // not where it is NaN
      if (is_nearer) p = next, left = left_then;
      damping *= is_nearer ? 0.1 : 10;
    }
    return p;
  }

  /// Says whether x is beyond the face that p is farthest beyond, and all points are not.
  bool is_apart(const Domain& domain, const Vec3& p, const Vec3& inside) {
    const auto side =
        std::ranges::max_element(domain, {}, [&](const HalfSpace& half) { return half.excess(p); });
    const Vec3 outward = glm::inverse(glm::transpose(slopes(inside))) * side->outward;
    if (!is_finite(outward)) return false;
    return std::all_of(arms_, arms_ + count_,
                       [&](const Vec3& arm) { return glm::dot(arm, outward) < 0; });
  }

  vtkGenericCell& cell_;
  int count_;
  Vec3 arms_[CellGrid::largest_cell];  // from x to the cell's points
  double diagonal_ = 0;                // of the cell's box
  bool is_near_ = false;               // x is in that box
};

}  // namespace

std::optional<Vec3> place_in_cell(vtkGenericCell& cell, const Vec3& x) {
  return CellInverse(cell, x).place();
}

}  // namespace pellucid::fields
