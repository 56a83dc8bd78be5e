// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "scene/scene.h"

namespace pellucid::scene {

/// A DepthRange is the linear map from view depth z (world units along the viewing axis) to d in
/// (0, 1): the one depth of ground truth and of every method.
struct DepthRange {
  double near = 0;  // z at d = 0
  double far = 1;   // z at d = 1

  double normalized(double z) const { return (z - near) / (far - near); }
};

/// DepthBounds gather the view depths of a scene's objects, one after another: none of them has to
/// stay in memory.
class DepthBounds {
 public:
  /// Takes the picture's camera and its size in pixels. Throws InputError for a camera that is too
  /// far away or that camera_frame() refuses.
  DepthBounds(const Camera& camera, int width, int height);
  ~DepthBounds();

  /// Throws InputError for coordinates that are too large.
  void add(const SceneObject& object);
  /// Returns depth_range() of the scene with all these objects; `scene` knows their names. Throws
  /// InputError when none of them is in front of the camera.
  DepthRange range(const Scene& scene) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Returns tight bounds of the scene's geometry in front of the camera, in world units, widened on
/// either side by a 1e-5th of their length so that no fragment lies on 0 or 1 after rounding to
/// float (a Fourier series is periodic there), but by no more than half the way to the eye, so that
/// depths next to the eye keep their digits.
///
/// Only what lies in the picture counts: triangles of meshes and ribbons are clipped to it, of
/// other shapes the boxes. Where nothing does, the bounds are those of all that is in front of the
/// camera. Geometry of one single depth, up to 2^-46 (1.4e-14) of its distance from the eye, which
/// is what rounding makes of a plane that faces the camera, lies at d = 0.5. Throws InputError when
/// nothing of the scene is in front of the camera.
DepthRange depth_range(const Scene& scene);

}  // namespace pellucid::scene
