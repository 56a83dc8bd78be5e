// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/opacity/element_opacity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "scene/elements/frame_memory.h"

namespace pellucid::oit {
namespace {

std::size_t count_points(const scene::Scene& scene) {
  std::size_t count = 0;
  for (const scene::SceneObject& object : scene.objects)
    if (const auto* points = std::get_if<scene::PointObject>(&object.shape))
      count += points->set.positions.size();
  return count;
}

BufferTexture numbers(const Gl& gl, std::vector<std::uint32_t> of_primitive, std::size_t first) {
  for (std::uint32_t& element : of_primitive) element += std::uint32_t(first);
  return {gl, GL_R32UI, Buffer(gl, of_primitive)};
}

/// The memory's elements of a kind, cut where there are none yet.
std::shared_ptr<const scene::Elements> remembered(
    scene::FrameMemory* memory, std::shared_ptr<const scene::Elements> scene::FrameMemory::*kind,
    const std::function<scene::Elements()>& cut) {
  if (memory && memory->*kind) return memory->*kind;
  auto elements = std::make_shared<const scene::Elements>(cut());
  if (memory) memory->*kind = elements;
  return elements;
}

}  // namespace

const OptionTable<ElementOptions>& element_options() {
  static const OptionTable<ElementOptions> table{
      number("segments", &ElementOptions::segments,
             {.min = 1,
              .max = 1e7,
              .unit = "segments",
              .help = "of equal length that all lines are cut into, about; each has one opacity"}),
      number("patches", &ElementOptions::patches,
             {.min = 1,
              .max = 1e6,
              .unit = "patches",
              .help = "of equal size that all surfaces are cut into, about; each has one opacity"}),
      choice("distances", &ElementOptions::distances,
             {{"edges", scene::SurfaceDistance::edges}, {"heat", scene::SurfaceDistance::heat}},
             "between points of a surface, for patches: along edges, or by the heat method"),
      number("smooth", &ElementOptions::smooth,
             {.min = 0,
              .max = 1000,
              .unit = "iterations",
              .help = "of Laplacian smoothing of the opacities of segments and patches"}),
      number("keep", &ElementOptions::keep,
             {.min = 0,
              .max = 1,
              .help = "along a camera path, the share of the last frame's opacities that stays"})};
  return table;
}

ElementOpacity::ElementOpacity(Stage& stage, const ElementOptions& options)
    : stage_(stage),
      iterations_(options.smooth),
      keep_(float(options.keep)),
      patches_(remembered(stage.memory(), &scene::FrameMemory::surfaces,
                          [&] {
                            return scene::surface_elements(
                                stage.scene(), std::size_t(options.patches), options.distances);
                          })),
      segments_(remembered(
          stage.memory(), &scene::FrameMemory::lines,
          [&] { return scene::line_elements(stage.scene(), std::size_t(options.segments)); })),
      points_(count_points(stage.scene())) {
  const Gl& gl = stage.gl();
  const std::size_t first_point = patches_->count() + segments_->count();
  textures_.of_triangle = numbers(gl, patches_->of_primitive, 0);
  textures_.of_segment = numbers(gl, segments_->of_primitive, patches_->count());
  textures_.first_point = std::uint32_t(first_point);
  textures_.opacities =
      BufferTexture(gl, GL_R32UI, Buffer::writable(gl, sizeof(float) * (first_point + points_)));
  stage.use_elements(textures_);
  begin();
  smoothed_.assign(first_point, 1.0f);
  upload_interpolated();
  stage.record("elements", patches_->bytes() + segments_->bytes() + textures_.of_triangle.bytes() +
                               textures_.of_segment.bytes() + textures_.opacities.bytes());
}

void ElementOpacity::begin() const {
  const Buffer& opacities = textures_.opacities.buffer();
  opacities.clear(opaque_bits);
  if (stage_.memory() && !stage_.memory()->least.empty())
    opacities.write<float>([&](float* to) { std::ranges::copy(stage_.memory()->least, to); });
}

void ElementOpacity::smooth_and_interpolate() {
  stage_.gl().MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
  std::vector<float> opacities(patches_->count() + segments_->count() +
                               (stage_.memory() ? points_ : 0));
  textures_.opacities.buffer().read(opacities.size() * sizeof(float), opacities.data());
  if (stage_.memory() && stage_.memory()->one_for_all_samples) stage_.memory()->least = opacities;
  smooth_found(opacities);
  if (stage_.memory()) blend_with_last(opacities);
  opacities.resize(smoothed_.size());  // points have theirs where they were found
  smoothed_ = std::move(opacities);
  upload_interpolated();
}

void ElementOpacity::smooth_found(std::vector<float>& opacities) const {
  auto at = opacities.begin();
  for (const scene::Elements* elements : {patches_.get(), segments_.get()}) {
    const auto end = at + std::ptrdiff_t(elements->count());
    std::vector<float> of_kind(at, end);
    scene::smooth(*elements, iterations_, of_kind);
    at = std::ranges::copy(of_kind, at).out;
  }
}

void ElementOpacity::blend_with_last(std::vector<float>& opacities) {
  scene::FrameMemory& memory = *stage_.memory();
  if (keep_ > 0 && memory.last.size() == opacities.size()) {
    for (std::size_t i = 0; i < opacities.size(); ++i)
      opacities[i] = std::lerp(opacities[i], memory.last[i], keep_);
    if (points_ > 0)
      textures_.opacities.buffer().write<float>(
          [&](float* to) { std::ranges::copy(opacities, to); });
  }
  memory.now = opacities;
}

std::vector<float> ElementOpacity::of_meshes() const {
  const auto begin = smoothed_.begin();
  return scene::vertex_opacities(*patches_, {begin, begin + std::ptrdiff_t(patches_->count())});
}

std::vector<float> ElementOpacity::of_lines() const {
  return scene::vertex_opacities(
      *segments_, {smoothed_.begin() + std::ptrdiff_t(patches_->count()), smoothed_.end()});
}

void ElementOpacity::upload_interpolated() const { stage_.set_opacities(of_meshes(), of_lines()); }

scene::OptimizedOpacities ElementOpacity::found() const {
  std::vector<float> all(smoothed_.size() + points_);
  textures_.opacities.buffer().read(all.size() * sizeof(float), all.data());
  return {of_meshes(), of_lines(), {all.begin() + std::ptrdiff_t(smoothed_.size()), all.end()}};
}

std::string ElementOpacity::describe() const {
  return fmt::format(
      "opacities: of least energy, of {} patches, {} segments of lines, {} points; "
      "smoothed {} times",
      patches_->count(), segments_->count(), points_, iterations_);
}

}  // namespace pellucid::oit
