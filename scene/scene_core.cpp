// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/scene_core.h"

#include <algorithm>
#include <numbers>
#include <numeric>

#include "scene/scene_fit.h"

namespace pellucid::scene {
namespace {

constexpr double kept_share = 0.98, slack = 1.25;

/// A number and how much it counts.
struct Weighted {
  double value, weight;
};

/// The least value up to which lies this share of all weight.
double quantile(std::vector<Weighted> values, double share) {
  std::ranges::sort(values, {}, &Weighted::value);
  double total = 0, sum = 0;
  for (const Weighted& v : values) total += v.weight;
  for (const Weighted& v : values)
    if ((sum += v.weight) >= share * total) return v.value;
  return values.back().value;
}

/// What is drawn around each vertex, in world units squared.
struct Extent {
  const SceneObject& object;

  std::vector<double> of(const geometry::TriangleMesh& mesh) const {
    std::vector<double> weights(mesh.positions.size());
    for (const auto& t : mesh.triangles) {
      const Vec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
      for (const auto i : t) weights[i] += glm::length(glm::cross(b - a, c - a)) / 6;
    }
    return weights;
  }
  std::vector<double> of(const LineObject& lines) const {
    const std::vector<Vec3>& x = lines.set.positions;
    std::vector<double> weights(x.size());
    for (std::size_t k = 0; k < lines.set.line_count(); ++k)
      for (std::size_t i = lines.set.offsets[k]; i + 1 < lines.set.offsets[k + 1]; ++i)
        for (const std::size_t end : {i, i + 1})
          weights[end] += glm::length(x[i + 1] - x[i]) * lines.radius.at(end);
    return weights;
  }
  std::vector<double> of(const PointObject& points) const {
    std::vector<double> weights(points.set.positions.size());
    for (std::size_t i = 0; i < weights.size(); ++i)
      weights[i] = std::numbers::pi * points.radius.at(i) * points.radius.at(i);
    return weights;
  }
  /// Its vertices are spread evenly over it.
  std::vector<double> of(const Isosurface&) const {
    const double size = object.bounds().diagonal();
    const std::size_t count = object.vertices().positions.size();
    return std::vector<double>(count, size * size / double(std::max(count, std::size_t(1))));
  }
};

std::vector<double> weights_of(const SceneObject& object) {
  std::vector<double> weights =
      std::visit([&](const auto& shape) { return Extent{object}.of(shape); }, object.shape);
  const std::vector<Rgba>& colors = object.vertices().colors;
  for (std::size_t i = 0; i < std::min(weights.size(), colors.size()); ++i)
    if (!object.opaque) weights[i] *= colors[i].a;
  return weights;
}

/// Calls visit(position, weight) for the vertices of all objects but halos, which go with lines.
template <class Visit>
void for_each_vertex(const Scene& scene, const Visit& visit) {
  for (const SceneObject& object : scene.objects) {
    if (object.is_halo) continue;
    const std::vector<double> weights = weights_of(object);
    for (std::size_t i = 0; i < weights.size(); ++i)
      visit(object.vertices().positions[i], weights[i]);
  }
}

Vec3 median(const Scene& scene) {
  Vec3 center(0);
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<Weighted> values;
    for_each_vertex(scene, [&](const Vec3& x, double weight) {
      values.push_back({x[axis], weight});
    });
    if (!values.empty()) center[axis] = quantile(std::move(values), 0.5);
  }
  return center;
}

std::vector<SceneOutliers> outliers_of(const Scene& scene, const SceneCore& core) {
  std::vector<SceneOutliers> all;
  for (const SceneObject& object : scene.objects) {
    SceneOutliers outliers{object.name};
    const std::vector<Vec3>& x = object.vertices().positions;
    for (std::size_t i = 0; i < x.size(); ++i)
      if (!object.is_halo && is_drawn(object, i) && !core.holds(x[i])) {
        ++outliers.count;
        outliers.distance = std::max(outliers.distance, glm::length(x[i] - core.center));
      }
    if (outliers.count > 0) all.push_back(std::move(outliers));
  }
  return all;
}

}  // namespace

SceneCore scene_core(const Scene& scene) {
  SceneCore core;
  core.center = median(scene);
  std::vector<Weighted> distances;
  double total = 0;
  for_each_vertex(scene, [&](const Vec3& x, double weight) {
    distances.push_back({glm::length(x - core.center), weight});
    total += weight;
  });
  if (distances.empty()) return core;
  core.radius = total > 0 ? slack * quantile(distances, kept_share)
                          : std::ranges::max(distances, {}, &Weighted::value).value;
  core.outliers = outliers_of(scene, core);
  return core;
}

Camera core_camera(const Scene& scene, const SceneCore& core, const ViewDirection& from) {
  CameraFit fit(scene.camera.projection, scene.camera.fov, from,
                double(scene.width) / double(scene.height));
  for (const SceneObject& object : scene.objects) {
    const std::vector<Vec3>& x = object.vertices().positions;
    for (std::size_t i = 0; i < x.size(); ++i)
      if (!object.is_halo && is_drawn(object, i) && core.holds(x[i]))
        fit.add(x[i], object.radii().at(i));
  }
  return fit.camera();
}

}  // namespace pellucid::scene
