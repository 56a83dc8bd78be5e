// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/scene_fit.h"

namespace pellucid::scene {

bool is_drawn(const SceneObject& object, std::size_t i) {
  return !std::holds_alternative<PointObject>(object.shape) || object.radii().at(i) > 0;
}

void show(const SceneObject& object, CameraFit& fit) {
  const std::vector<Vec3>& x = object.vertices().positions;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (is_drawn(object, i)) fit.add(x[i], object.radii().at(i));
}

Camera fitted_camera(const Scene& scene, const ViewDirection& from) {
  CameraFit fit(scene.camera.projection, scene.camera.fov, from,
                double(scene.width) / double(scene.height));
  for (const SceneObject& object : scene.objects) show(object, fit);
  return fit.camera();
}

bool has_fitted_camera(const Scene& scene) {
  const auto how = scene.provenance.find("camera");
  return how != scene.provenance.end() && how->second.starts_with("fitted");
}

}  // namespace pellucid::scene
