#include "oit/element_opacity.h"

#include <fmt/format.h>

#include <algorithm>

namespace pellucid {
namespace {

std::size_t count_points(const Scene& scene) {
  std::size_t count = 0;
  for (const SceneObject& object : scene.objects)
    if (const auto* points = std::get_if<PointObject>(&object.shape))
      count += points->set.positions.size();
  return count;
}

BufferTexture numbers(const Gl& gl, std::vector<std::uint32_t> of_primitive, std::size_t first) {
  for (std::uint32_t& element : of_primitive) element += std::uint32_t(first);
  return {gl, GL_R32UI, Buffer(gl, of_primitive)};
}

}  // namespace

bool has_importance(const Scene& scene) {
  return std::ranges::any_of(scene.objects, [](const SceneObject& object) {
    return !object.opaque &&
           std::ranges::any_of(object.vertices().importance, [](float g) { return g > 0; });
  });
}

ElementOpacity::ElementOpacity(Stage& stage, const Parameters& parameters)
    : stage_(stage),
      iterations_(parameters.integer("smooth")),
      patches_(surface_elements(stage.scene(), std::size_t(parameters.integer("patches")))),
      segments_(line_elements(stage.scene(), std::size_t(parameters.integer("segments")))),
      points_(count_points(stage.scene())) {
  const Gl& gl = stage.gl();
  const std::size_t first_point = patches_.count() + segments_.count();
  textures_.of_triangle = numbers(gl, patches_.of_primitive, 0);
  textures_.of_segment = numbers(gl, segments_.of_primitive, patches_.count());
  textures_.first_point = std::uint32_t(first_point);
  textures_.opacities = BufferTexture(gl, GL_R32UI, sizeof(float) * (first_point + points_));
  stage.use_elements(textures_);
  begin();
  smooth_and_interpolate();
  stage.record("elements", patches_.bytes() + segments_.bytes() + textures_.of_triangle.bytes() +
                               textures_.of_segment.bytes() + textures_.opacities.bytes());
}

void ElementOpacity::smooth_and_interpolate() {
  stage_.gl().MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
  std::vector<float> patches(patches_.count()), segments(segments_.count());
  std::vector<float> all(patches.size() + segments.size());
  textures_.opacities.buffer().read(all.size() * sizeof(float), all.data());
  std::copy_n(all.begin(), patches.size(), patches.begin());
  std::copy(all.begin() + std::ptrdiff_t(patches.size()), all.end(), segments.begin());
  smooth(patches_, iterations_, patches);
  smooth(segments_, iterations_, segments);
  stage_.set_opacities(vertex_opacities(patches_, patches), vertex_opacities(segments_, segments));
}

std::string ElementOpacity::describe() const {
  return fmt::format(
      "opacities: of least energy, of {} patches, {} segments of lines, {} points; "
      "smoothed {} times",
      patches_.count(), segments_.count(), points_, iterations_);
}

}  // namespace pellucid
