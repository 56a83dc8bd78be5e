// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/run/frame_sequence.h"

#include <algorithm>
#include <cmath>

#include "compare/methods/optimize_opacities.h"
#include "compare/pictures/metrics.h"
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

scene::Rendering render_frame(const scene::Scene& scene, const MethodCall& method,
                              const std::optional<MethodCall>& opacities,
                              scene::RenderContext context) {
  if (!opacities) return method.row->make(scene, method.parameters, context)->render({});
  scene::Scene optimized = scene;
  optimize_opacities(*opacities, context, optimized);
  context.memory = nullptr;
  return method.row->make(optimized, method.parameters, context)->render({});
}

}  // namespace

void render_sequence(scene::Scene& scene, const MethodCall& method,
                     const std::optional<MethodCall>& opacities, scene::RenderContext context,
                     const std::function<void(const SequenceFrame&)>& done) {
  scene::FrameMemory memory;
  context.memory = &memory;
  Image last;
  scene::Camera before = scene.camera;
  for (std::size_t i = 0; i < scene.camera_path.size(); ++i) {
    scene.camera = scene.camera_path[i];
    scene::place_halos(scene);
    SequenceFrame frame{int(i), scene.camera, {}, {}, {}, {}};
    if (i > 0) frame.motion = scene::motion(before, scene.camera);
    frame.rendering = render_frame(scene, method, opacities, context);
    frame.opacity = change_of(memory);
    if (i > 0) frame.picture = rmse(last, frame.rendering.image);
    done(frame);
    last = std::move(frame.rendering.image);
    before = scene.camera;
    memory.next_frame();
  }
}

}  // namespace pellucid::compare
