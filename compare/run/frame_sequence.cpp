// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/run/frame_sequence.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "compare/methods/optimize_opacities.h"
#include "scene/elements/frame_memory.h"
#include "scene/halo.h"

namespace pellucid::compare {
namespace {

std::optional<Change> change_of(const scene::FrameMemory& memory) {
  if (memory.last.empty() || memory.last.size() != memory.now.size()) return std::nullopt;
  Change change;
  for (std::size_t i = 0; i < memory.now.size(); ++i) {
    const double by = std::abs(double(memory.now[i]) - double(memory.last[i]));
    change.mean += by / double(memory.now.size());
    change.largest = std::max(change.largest, by);
  }
  return change;
}

/// A frame's picture, and the reference's where there is one.
struct Drawn {
  scene::Rendering rendering;
  std::optional<scene::Rendering> reference;  // with layers
};

scene::Rendering draw(const scene::Scene& scene, const MethodCall& method,
                      const scene::RenderContext& context, bool layers = false) {
  return method.row->make(scene, method.parameters, context)->render({.layers = layers});
}

/// Only what chooses opacities remembers: the stage of its own, or the method.
Drawn draw_frame(const scene::Scene& scene, const MethodCall& method,
                 const std::optional<MethodCall>& opacities,
                 const std::optional<MethodCall>& reference, const scene::RenderContext& context) {
  scene::RenderContext forgetful = context;
  forgetful.memory = nullptr;
  const auto draw_both = [&](const scene::Scene& seen, const scene::RenderContext& with) {
    Drawn drawn{draw(seen, method, with), std::nullopt};
    if (reference) drawn.reference = draw(seen, *reference, forgetful, true);
    return drawn;
  };
  if (!opacities) return draw_both(scene, context);
  scene::Scene optimized = scene;
  std::vector<MethodCall> calls;
  calls.push_back(method);
  if (reference) calls.push_back(*reference);
  optimize_opacities(*opacities, context, optimized, further_samplings(calls));
  return draw_both(optimized, forgetful);
}

/// Compares frames with the reference's, one after another.
class FrameErrors {
 public:
  FrameError next(const scene::Rendering& reference, const Image& test) {
    Image error = test;
    for (std::size_t i = 0; i < error.pixels.size(); ++i)
      error.pixels[i] -= reference.image.pixels[i];
    const CountImage* layers = reference.layers.pixels.empty() ? nullptr : &reference.layers;
    FrameError found{
        compare_images(reference.image, test,
                       {.mask = nullptr, .reference_layers = layers, .test_layers = nullptr}),
        std::nullopt};
    if (!last_.pixels.empty()) found.flicker = rmse(last_, error);
    last_ = std::move(error);
    return found;
  }

 private:
  Image last_;  // signed error
};

}  // namespace

void render_sequence(scene::Scene& scene, const MethodCall& method,
                     const std::optional<MethodCall>& opacities, scene::RenderContext context,
                     const std::function<void(const SequenceFrame&)>& done,
                     const std::optional<MethodCall>& reference) {
  scene::FrameMemory memory;
  context.memory = &memory;
  FrameErrors errors;
  Image last;
  scene::Camera before = scene.camera;
  for (std::size_t i = 0; i < scene.camera_path.size(); ++i) {
    scene.camera = scene.camera_path[i];
    scene::place_halos(scene);
    SequenceFrame frame{int(i), scene.camera, {}, {}, {}, {}, {}};
    if (i > 0) frame.motion = scene::motion(before, scene.camera);
    Drawn drawn = draw_frame(scene, method, opacities, reference, context);
    frame.rendering = std::move(drawn.rendering);
    if (drawn.reference) frame.error = errors.next(*drawn.reference, frame.rendering.image);
    frame.opacity = change_of(memory);
    if (i > 0) frame.picture = rmse(last, frame.rendering.image);
    done(frame);
    last = std::move(frame.rendering.image);
    before = scene.camera;
    memory.next_frame();
  }
}

}  // namespace pellucid::compare
