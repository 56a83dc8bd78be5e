// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "groundtruth/shapes/isosurface_geometry.h"

namespace pellucid::groundtruth {

/// An ExactIsosurface is the surface where a reconstruction over levels of samples takes a value,
/// crossed exactly. A box is a lattice cell of the finest level there, of those whose samples lie
/// on both sides of the value. Along a ray the reconstruction's numerator is a polynomial within
/// each lattice cell (see LevelField): all its sign changes are isolated, with an error of some ulp
/// of the ray's length.
///
/// Faces are planes of constant ray parameter that do not depend on the cell that asks, cells hold
/// their first end and not their last, and the sign at an end is that of one evaluation which all
/// cells share: no crossing is missed or counted twice at the faces of cells and levels. A value of
/// 0 counts as inside, so that a plateau at the surface's value is bounded but not filled. Where a
/// reconstruction jumps across the value, the ray crosses on the face.
///
/// Of a part of a scene it holds some of the cells, numbered as in the whole surface.
class ExactIsosurface final : public IsosurfaceGeometry {
 public:
  ExactIsosurface(const scene::Isosurface& surface, std::uint32_t index,
                  const GeometryContext& context);

  std::uint32_t box_count() const override { return static_cast<std::uint32_t>(cells_.size()); }
  Box3 box(std::uint32_t k) const override;
  void cross(std::uint32_t k, const SceneRay& ray, std::vector<Crossing>& crossings) const override;
  std::uint64_t bytes() const override { return cells_.size() * sizeof(fields::LatticeCell); }

 private:
  std::vector<fields::LatticeCell> cells_;
  std::uint32_t first_ = 0;  // the first cell's number
};

}  // namespace pellucid::groundtruth
