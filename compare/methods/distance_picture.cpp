// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/methods/distance_picture.h"

#include <cmath>

#include "compare/pictures/error_map.h"
#include "groundtruth/methods/raytrace.h"

namespace pellucid::compare {
namespace {

scene::Scene lit_scene(const scene::Scene& view) {
  scene::Scene scene;
  scene.width = view.width;
  scene.height = view.height;
  scene.samples = view.samples;
  scene.camera = view.camera;
  scene.background = view.background;
  scene.lighting = scene::Lighting::headlight;
  return scene;
}

/// Whole decades, so that pictures of nearly equal surfaces have the same scale.
double decade_of(double length) { return std::pow(10, std::round(std::log10(length))); }

}  // namespace

scene::MeasurePicture distance_picture(const scene::Scene& view, geometry::TriangleMesh mesh,
                                       const std::vector<double>& distances) {
  const double diagonal = decade_of(mesh.bounds().diagonal());
  scene::MeasurePicture picture{"distance",
                                "Distance to the exact surface [world units]",
                                1e-6 * diagonal,
                                1e-2 * diagonal,
                                {}};
  mesh.colors.clear();
  for (const double distance : distances)
    mesh.colors.emplace_back(logarithmic_color(distance, picture.min, picture.max), 1);
  scene::ensure_normals(mesh);
  scene::Scene scene = lit_scene(view);
  scene.objects.push_back({"distance", std::move(mesh)});
  picture.image =
      groundtruth::raytrace_method()
          .make(scene, Parameters("raytrace", groundtruth::raytrace_method().parameters, {}), {})
          ->render({})
          .image;
  return picture;
}

}  // namespace pellucid::compare
