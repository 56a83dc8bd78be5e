// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "compare/methods/method_call.h"
#include "compare/pictures/metrics.h"
#include "scene/renderer.h"
#include "scene/view/camera_path.h"

namespace pellucid::compare {

/// A Change says how a number per element changed from the frame before: the mean and the largest
/// absolute difference over all elements.
struct Change {
  double mean = 0, largest = 0;
};

/// A FrameError is how far a frame is from the reference's, and how the error flickers.
struct FrameError {
  Comparison metrics;
  /// The root mean square, over RGB, of the change of the signed error since the frame before: what
  /// the method changes beyond what the exact picture does. Nothing in the first frame.
  std::optional<double> flicker;
};

/// A SequenceFrame is a frame of a camera path, and what changed since the one before; nothing did
/// before the first.
struct SequenceFrame {
  int index = 0;
  scene::Camera camera;
  scene::CameraMotion motion;
  scene::Rendering rendering;
  std::optional<Change> opacity;    // of the elements; none where the method optimizes none
  std::optional<double> picture;    // root mean square over RGB
  std::optional<FrameError> error;  // where there is a reference
};

/// Renders the scene from each camera of its path in turn and calls `done` with each frame. Shapes
/// that face the eye are made anew for each; what the method remembers (FrameMemory) goes on from
/// frame to frame. With `opacities` the method composites those that this call finds, frame by
/// frame, and this is what remembers; see optimize_opacities(). With a `reference` each frame is
/// drawn by it, too, of the same opacities, and compared. Leaves the scene with the last camera.
void render_sequence(scene::Scene& scene, const MethodCall& method,
                     const std::optional<MethodCall>& opacities, scene::RenderContext context,
                     const std::function<void(const SequenceFrame&)>& done,
                     const std::optional<MethodCall>& reference = std::nullopt);

}  // namespace pellucid::compare
