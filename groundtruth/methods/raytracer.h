// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "groundtruth/levels/level_march.h"
#include "groundtruth/rays/exact_sign.h"
#include "scene/renderer.h"

namespace pellucid::groundtruth {

inline constexpr ParameterSpec stop_below_parameter = {
    .name = "stop-below",
    .kind = ParameterSpec::Kind::real,
    .default_value = "0",
    .min = 0,
    .max = 1,
    .help = "a ray ends where less than this shows: no pixel then errs by more"};

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
std::unique_ptr<scene::Renderer> make_raytracer(const scene::Scene& scene,
                                                const TraceOptions& options);

}  // namespace pellucid::groundtruth
