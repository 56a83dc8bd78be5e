#pragma once

#include <optional>

#include "groundtruth/exact_sign.h"
#include "groundtruth/level_march.h"
#include "scene/renderer.h"

namespace pellucid {

/// The exact composite by Embree's all-hit traversal.
const MethodRow& raytrace_method();

struct TraceOptions {
  Precision precision = Precision::exact;
  double stop_below = 0;                   // a ray ends where less than this shows
  std::optional<MarchOptions> march = {};  // isosurfaces are marched; else crossed exactly
};

/// Throws InputError for a scene that lies behind the camera. The scene has to outlive it.
std::unique_ptr<Renderer> make_raytracer(const Scene& scene, const TraceOptions& options);

}  // namespace pellucid
