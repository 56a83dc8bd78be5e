// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "scene/elements/elements.h"

namespace pellucid::scene {

/// A FrameMemory is what a method that optimizes opacities keeps along a camera path: made for one
/// scene and one set of parameters, and given to the renderer of each frame in turn.
struct FrameMemory {
  /// Elements do not depend on the camera: they are cut in the first frame and used in all.
  std::shared_ptr<const Elements> surfaces, lines;

  /// These are the opacities of each element, in [0, 1]: patches, segments, points. They are empty
  /// where nothing is optimized.
  std::vector<float> last, now;

  /// Says whether an element has one opacity for all that is drawn of a frame, as a scene's own
  /// opacities are: the least over all samples of a pixel, in all pictures of the frame until now.
  /// Otherwise every sample finds its own.
  bool one_for_all_samples = false;
  /// These are the least ones until now, before they are smoothed; empty until there are some.
  std::vector<float> least;

  /// Ends a frame: its opacities become the last ones.
  void next_frame() {
    last = std::move(now);
    now.clear();
    least.clear();
  }
};

}  // namespace pellucid::scene
