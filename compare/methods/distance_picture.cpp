#include "compare/methods/distance_picture.h"

#include <cmath>

#include "compare/pictures/error_map.h"
#include "groundtruth/methods/raytrace.h"

namespace pellucid {
namespace {

Scene lit_scene(const Scene& view) {
  Scene scene;
  scene.width = view.width;
  scene.height = view.height;
  scene.samples = view.samples;
  scene.camera = view.camera;
  scene.background = view.background;
  scene.lighting = Lighting::headlight;
  return scene;
}

/// Whole decades, so that pictures of nearly equal surfaces have the same scale.
double decade_of(double length) { return std::pow(10, std::round(std::log10(length))); }

}  // namespace

MeasurePicture distance_picture(const Scene& view, TriangleMesh mesh,
                                const std::vector<double>& distances) {
  const double diagonal = decade_of(mesh.bounds().diagonal());
  MeasurePicture picture{"distance",
                         "Distance to the exact surface [world units]",
                         1e-6 * diagonal,
                         1e-2 * diagonal,
                         {}};
  mesh.colors.clear();
  for (const double distance : distances)
    mesh.colors.emplace_back(logarithmic_color(distance, picture.min, picture.max), 1);
  ensure_normals(mesh);
  Scene scene = lit_scene(view);
  scene.objects.push_back({"distance", std::move(mesh)});
  picture.image = raytrace_method()
                      .make(scene, Parameters("raytrace", raytrace_method().parameters, {}), {})
                      ->render({})
                      .image;
  return picture;
}

}  // namespace pellucid
