// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <filesystem>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <shared_mutex>
#include <string>

#include "compare/pictures/picture_text.h"
#include "core/raster.h"
#include "groundtruth/sums/ray_sums.h"
#include "scene/files/scene_file.h"
#include "scene/scene_fit.h"

namespace pellucid::python {

/// A Scene is one that Python holds. Threads that look at it share `mutex`; who changes it has it
/// alone, and no thread waits for it while it has Python's lock.
class Scene {
 public:
  /// Takes where relative paths of what is added start. A camera that nobody has given is fitted
  /// again when the scene changes.
  Scene(scene::Scene scene, std::filesystem::path folder)
      : scene_(std::move(scene)),
        folder_(std::move(folder)),
        fits_camera_(scene::has_fitted_camera(scene_)) {}

  const std::filesystem::path& folder() const { return folder_; }

  /// Calls look(scene), without Python's lock.
  template <class Look>
  auto with(const Look& look) const {
    const std::shared_lock lock(mutex_);
    return look(scene_);
  }
  /// Calls change(scene); the camera then sees all, if it was not given. Throws WorkError when
  /// another thread is looking.
  void change(const std::function<void(scene::Scene&)>& change);
  /// Changes what a scene file says of the view (see change_view()).
  void set_view(const nlohmann::json& text);

  /// Calls look(scene, probe), without Python's lock; the probe is made once for several calls.
  template <class Look>
  auto with_probe(const Look& look) {
    const std::shared_lock lock(mutex_);
    const std::shared_ptr<const groundtruth::RayProbe> probe = probe_of_now();
    return look(scene_, *probe);
  }

 private:
  std::shared_ptr<const groundtruth::RayProbe> probe_of_now();

  scene::Scene scene_;
  std::filesystem::path folder_;
  bool fits_camera_;
  mutable std::shared_mutex mutex_;
  std::mutex probe_mutex_;
  std::shared_ptr<const groundtruth::RayProbe> probe_;
};

/// A Rendering is a picture that Python holds.
struct Rendering {
  std::shared_ptr<Image> image;
  std::shared_ptr<CountImage> layers;
  nlohmann::json stats;
  compare::PictureForm form;  // how its picture is written
};

/// Adds load_scene(), Scene and Rendering to the module.
void define_scene(pybind11::module_& module);
/// Adds to Scene what it knows of rays, and Crossings and Deep to the module.
void define_rays(pybind11::module_& module, pybind11::class_<Scene, std::shared_ptr<Scene>>& scene);

/// Returns a picture as a PNG file's bytes, as a notebook shows it.
std::string png_of(const Image& image);

}  // namespace pellucid::python
