#pragma once

#include <optional>

#include "groundtruth/exact_sign.h"
#include "groundtruth/level_march.h"
#include "scene/renderer.h"

namespace pellucid {

struct TraceOptions {
  Precision precision = Precision::exact;
  double stop_below = 0;                   // a ray ends where less than this shows
  std::optional<MarchOptions> march = {};  // isosurfaces are marched; else crossed exactly

  /// A pixel that differs from one of its eight neighbours by more than `contrast` in some channel
  /// is traced again, with adaptive × adaptive samples, until no further one differs; 1: none is.
  int adaptive = 1;
  double contrast = 0;
};

/// Throws InputError for a scene that lies behind the camera, and for fewer adaptive samples than
/// the scene's own. The scene has to outlive it.
std::unique_ptr<Renderer> make_raytracer(const Scene& scene, const TraceOptions& options);

}  // namespace pellucid
