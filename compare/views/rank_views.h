// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "compare/views/view_score.h"
#include "core/progress.h"
#include "scene/scene_core.h"

namespace pellucid::compare {

/// A RankedView is a camera worth having.
struct RankedView {
  scene::Camera camera;
  double azimuth = 0,
         elevation = 0;  // of the eye from the core's centre, degrees; see sphere_views()
  ViewScore score;
  double worth = 0;  // in [0, 1]: 1 shows most
};

/// A SphereView is a side from which to look, by its angles.
struct SphereView {
  double azimuth = 0, elevation = 0;  // degrees
  scene::ViewDirection direction;
};

/// Returns `count` sides, spread evenly (a Fibonacci lattice) over all but the caps within 20
/// degrees of the poles, where `up` would be along the view. The elevation is above the plane that
/// `up` is normal to; the azimuth turns about `up`, from the axis most unlike it.
std::vector<SphereView> sphere_views(int count, const Vec3& up);

/// Ranks cameras around a scene's core by what they show and returns the best, most worth first, no
/// two of which look from sides less than 30 degrees apart; fewer where there are no more such. The
/// worth is the number of visible layers over the whole picture, times the visible importance where
/// the scene has any, each as a share of the most. `samples` pixels along the picture's longer side
/// are looked through. The scene is left with another camera and resolution.
std::vector<RankedView> rank_views(scene::Scene& scene, const scene::SceneCore& core, int count,
                                   int samples, const Progress& progress);

}  // namespace pellucid::compare
