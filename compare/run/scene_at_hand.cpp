// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/run/scene_at_hand.h"

#include <fmt/format.h>

#include "compare/methods/optimize_opacities.h"
#include "compare/pictures/image_file.h"
#include "core/error.h"
#include "core/files/files_read.h"
#include "scene/files/scene_file.h"
#include "scene/halo.h"
#include "scene/view/camera_path.h"

namespace pellucid::compare {

namespace fs = std::filesystem;

namespace {

/// Nothing for the scene's own camera alone.
std::vector<scene::Camera> cameras_of(const Views& views, const scene::Scene& scene) {
  if (views.path && scene.camera_path.empty())
    throw InputError(fmt::format(
        "views: \"path\": {} has no camera_path; accepted: one, a number of views, or a list of "
        "cameras",
        scene.name));
  if (views.path) return scene.camera_path;
  if (views.orbit == 0) return views.cameras;
  // The last one stands a step before the first.
  return scene::orbit(scene.camera, 360.0 * (views.orbit - 1) / views.orbit, views.orbit);
}

}  // namespace

scene::Scene& SceneAtHand::loaded() {
  if (loaded_) return *loaded_;
  scene::Scene scene = scene::load_scene(file_);
  cameras_ = cameras_of(study_.views, scene);
  if (cameras_.empty()) optimize(scene);
  loaded_ = std::move(scene);
  return *loaded_;
}

void SceneAtHand::optimize(scene::Scene& scene) {
  if (!study_.opacities) return;
  scene::RenderContext context = context_;
  if (study_.views.path) context.memory = &memory_;
  optimize_opacities(*study_.opacities, context, scene, further_samplings(study_));
}

scene::Scene SceneAtHand::seen_from(std::size_t view) {
  scene::Scene scene = *loaded_;
  scene.camera = cameras_.at(view);
  scene::place_halos(scene);
  optimize(scene);
  return scene;
}

std::size_t SceneAtHand::view_count() {
  if (!study_.views.any()) return 1;
  loaded();
  return cameras_.size();
}

void SceneAtHand::look_from(std::size_t view) {
  if (view == view_) return;
  view_ = view;
  seen_.reset();
  reference_ = {};
  layers_ = {};
  rays_.reset();
}

const scene::Scene& SceneAtHand::scene() {
  if (seen_) return *seen_;
  loaded();
  if (cameras_.empty()) return *loaded_;
  if (!study_.views.path || !study_.opacities) return seen_.emplace(seen_from(view_));
  if (remembered_ > view_) {  // looks back: along the path anew
    memory_ = {};
    remembered_ = 0;
  }
  for (; remembered_ <= view_; ++remembered_) {
    if (remembered_ > 0) memory_.next_frame();
    seen_ = seen_from(remembered_);
  }
  return *seen_;
}

const Image& SceneAtHand::reference() {
  const UnnotedReads own;  // what the study has written itself is no input of its
  if (reference_.pixels.empty()) reference_ = read_image(files().picture());
  return reference_;
}

const CountImage& SceneAtHand::reference_layers() {
  const UnnotedReads own;
  if (layers_.pixels.empty()) layers_ = read_counts(files().layers());
  return layers_;
}

const RayFacts& SceneAtHand::ray_facts() {
  if (!rays_) rays_ = compare::ray_facts(scene());
  return *rays_;
}

bool SceneAtHand::has_reference_layers() const { return fs::exists(files().layers()); }

std::map<std::string, std::string> SceneAtHand::files_read() {
  std::map<std::string, std::string> files = files_of_reference_;
  for (const fs::path& path : read_.paths()) files.emplace(path.string(), hashes_.of(path));
  return files;
}

}  // namespace pellucid::compare
