// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/options/option_table.h"
#include "groundtruth/levels/level_march.h"
#include "groundtruth/rays/exact_sign.h"
#include "scene/renderer.h"

namespace pellucid::groundtruth {

/// RaytraceOptions are those of the method `raytrace`.
struct RaytraceOptions {
  Precision precision = Precision::exact;
  double stop_below = 0;  // a ray ends where less than this share shows

  /// A pixel that differs from one of its eight neighbours by more than `contrast` in some channel
  /// is traced again, with adaptive × adaptive samples, until no further one differs; 1: none is.
  int adaptive = 1;
  double contrast = 0.01;  // of a channel, 0 to 1

  bool operator==(const RaytraceOptions&) const = default;
};

/// The row `stop-below` of a method that is made of such rays.
template <class Options>
Option<Options> stop_below_option(double Options::*member) {
  return number("stop-below", member,
                {.min = 0,
                 .max = 1,
                 .help = "a ray ends where less than this shows: no pixel then errs by more"});
}

/// With `march` isosurfaces are marched, not crossed exactly. Throws InputError for a scene that
/// lies behind the camera, and for fewer adaptive samples than the scene's own. The scene has to
/// outlive it.
std::unique_ptr<scene::Renderer> make_raytracer(const scene::Scene& scene,
                                                const RaytraceOptions& options,
                                                const std::optional<MarchOptions>& march = {});

}  // namespace pellucid::groundtruth
