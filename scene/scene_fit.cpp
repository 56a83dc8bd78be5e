// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/scene_fit.h"

namespace pellucid::scene {

double drawn_radius(const SceneObject& object) {
  if (const auto* lines = std::get_if<LineObject>(&object.shape)) return lines->radius;
  if (const auto* points = std::get_if<PointObject>(&object.shape)) return points->radius;
  return 0;
}

void show(const SceneObject& object, CameraFit& fit) {
  for (const Vec3& x : object.vertices().positions) fit.add(x, drawn_radius(object));
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
