// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/shapes/exact_isosurface.h"

#include "fields/levels/surface_cells.h"

namespace pellucid::groundtruth {

ExactIsosurface::ExactIsosurface(const scene::Isosurface& surface, std::uint32_t index,
                                 const GeometryContext& context)
    : IsosurfaceGeometry(surface, index, context),
      cells_(fields::surface_cells(*surface.field, surface.value)) {
  check_count(cells_.size(), "cells of an isosurface");
  const scene::Share share = scene::share_of_cells(cells_.size(), index, context.part);
  first_ = std::uint32_t(share.begin);
  cells_.erase(cells_.begin() + std::ptrdiff_t(share.end), cells_.end());
  cells_.erase(cells_.begin(), cells_.begin() + std::ptrdiff_t(share.begin));
}

Box3 ExactIsosurface::box(std::uint32_t k) const {
  return view_box(fields::cell_box(field(), cells_[k]));
}

void ExactIsosurface::cross(std::uint32_t k, const SceneRay& ray,
                            std::vector<Crossing>& crossings) const {
  const WorldRay world = to_world(ray);
  thread_local std::vector<double> at;
  at.clear();
  append_level_crossings(field(), surface().value, cells_[k], world, at);
  for (const double t : at) append(ray, world, t, first_ + k, crossings);
}

}  // namespace pellucid::groundtruth
