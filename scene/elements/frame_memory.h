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

  /// Ends a frame: its opacities become the last ones.
  void next_frame() {
    last = std::move(now);
    now.clear();
  }
};

}  // namespace pellucid::scene
