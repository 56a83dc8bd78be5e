// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "groundtruth/levels/level_march.h"
#include "groundtruth/shapes/isosurface_geometry.h"

namespace pellucid::groundtruth {

/// A MarchedIsosurface is an isosurface as a ray march finds it (see LevelMarch): one box, the
/// field's bounds. A march ends where less than `context.stop_below` of what lies behind shows
/// through the surface alone, and at the first crossing with an opaque one, or where the ray enters
/// one of `context.stops`.
class MarchedIsosurface final : public IsosurfaceGeometry {
 public:
  MarchedIsosurface(const scene::Isosurface& surface, bool opaque, std::uint32_t index,
                    const GeometryContext& context, const MarchOptions& options);

  std::uint32_t box_count() const override { return 1; }
  Box3 box(std::uint32_t) const override { return view_box(field().bounds()); }
  void cross(std::uint32_t k, const SceneRay& ray, std::vector<Crossing>& crossings) const override;
  std::uint64_t bytes() const override { return march_.bytes(); }

 private:
  LevelMarch march_;
  bool opaque_;
  double stop_below_;
  std::vector<scene::Isosurface::Ball> stops_;
};

}  // namespace pellucid::groundtruth
