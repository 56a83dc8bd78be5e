// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "scene/elements/elements.h"

namespace pellucid::scene {

/// What a method that optimizes opacities keeps along a camera path: made for one scene and one set
/// of parameters, and given to the renderer of each frame in turn.
struct FrameMemory {
  /// Object space does not see the camera: cut in the first frame, used in all.
  std::shared_ptr<const Elements> surfaces, lines;

  /// The opacity of each element: patches, segments, points. Empty where nothing is optimized.
  std::vector<float> last, now;

  /// After a frame: its opacities are the last ones.
  void next_frame() {
    last = std::move(now);
    now.clear();
  }
};

}  // namespace pellucid::scene
