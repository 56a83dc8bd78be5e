// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "core/options/option_table.h"
#include "core/progress.h"
#include "core/raster.h"
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

/// Takes rows of a picture, of which the first is row `first` of it (0 at the top).
using TakeRows = std::function<void(int first, const Image& rows)>;

/// A RowRaytracer can draw a picture that does not fit in the memory.
class RowRaytracer : public scene::Renderer {
 public:
  /// Draws the picture so many rows at a time, from the top, and hands each over; the last may be
  /// fewer. They are those of render() to the last bit. Throws InputError for adaptive samples,
  /// which ask for a pixel's neighbours.
  virtual scene::RenderStats render_rows(int rows, const TakeRows& take,
                                         const Progress& progress) = 0;
};

/// With `march` isosurfaces are marched, not crossed exactly. Throws InputError for a scene that
/// lies behind the camera, and for fewer adaptive samples than the scene's own. The scene has to
/// outlive it.
std::unique_ptr<RowRaytracer> make_raytracer(const scene::Scene& scene,
                                             const RaytraceOptions& options,
                                             const std::optional<MarchOptions>& march = {});

/// A TurningRaytracer draws a scene that turns: its camera, size, samples and halos may change
/// before each turn(), which takes far less time than making a raytracer. Pictures are the same to
/// the last bit; of a scene that lies behind the camera it is the background's.
class TurningRaytracer : public RowRaytracer {
 public:
  /// Takes the scene as it is now. Throws InputError for fewer adaptive samples than the scene's
  /// own.
  virtual void turn() = 0;
};

/// Makes one for the scene, which has to outlive it. Throws as turn() does.
std::unique_ptr<TurningRaytracer> make_turning_raytracer(const scene::Scene& scene,
                                                         const RaytraceOptions& options);

}  // namespace pellucid::groundtruth
