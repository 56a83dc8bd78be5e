// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "scene/view/camera_fit.h"

namespace pellucid::scene {

/// SceneOutliers are the vertices of one object that lie far from most of what is drawn.
struct SceneOutliers {
  std::string object;     // its name
  std::size_t count = 0;  // of vertices
  double distance = 0;    // of the farthest from the core's centre, world units
};

/// A SceneCore is the ball that holds most of what is drawn. A vertex counts by what is drawn
/// around it, times its opacity: of meshes a third of its triangles' area, of lines half of its
/// segments' length times the width there, of points a disc. The centre is the median along each
/// axis; the radius is a quarter more than that of 98 % of what counts, so that what trails off
/// evenly is kept whole.
struct SceneCore {
  Vec3 center{0};     // world
  double radius = 0;  // world units
  std::vector<SceneOutliers> outliers;

  bool holds(const Vec3& x) const { return glm::length(x - center) <= radius; }
};

/// Finds the core. Of a scene in which nothing counts, all transparent to the last, it holds all.
SceneCore scene_core(const Scene& scene);

/// Returns the camera that sees the core from that side, as large as it can be, with the scene's
/// resolution, projection and vertical angle.
Camera core_camera(const Scene& scene, const SceneCore& core, const ViewDirection& from);

}  // namespace pellucid::scene
