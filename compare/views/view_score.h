// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.h"

namespace pellucid::compare {

/// A ViewScore says how much of a scene a camera shows. A layer is visible where it changes its
/// pixel by a step of 8 bits or more: its opacity times the transmittance of what is in front.
struct ViewScore {
  double covered = 0;     // share of the picture with a layer
  double layers = 0;      // visible ones, mean over the covered part
  double hidden = 0;      // share of the layers that are not visible
  double importance = 0;  // mean over the picture of what is seen of it, Σ g α T; 0 without any
};

/// Scores the scene as its camera sees it, by one ray for each of its pixels. Throws as
/// groundtruth::RayProbe does.
ViewScore view_score(const scene::Scene& scene);

}  // namespace pellucid::compare
