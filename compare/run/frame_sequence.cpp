// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/run/frame_sequence.h"

#include <algorithm>
#include <cmath>

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

}  // namespace

void render_sequence(scene::Scene& scene, const scene::MethodRow& row, const Parameters& parameters,
                     scene::RenderContext context,
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
    frame.rendering = row.make(scene, parameters, context)->render({});
    frame.opacity = change_of(memory);
    if (i > 0) frame.picture = rmse(last, frame.rendering.image);
    done(frame);
    last = std::move(frame.rendering.image);
    before = scene.camera;
    memory.next_frame();
  }
}

}  // namespace pellucid::compare
