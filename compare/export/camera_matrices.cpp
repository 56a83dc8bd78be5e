// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/export/camera_matrices.h"

#include <algorithm>

namespace pellucid::compare {
namespace {

/// The nearest plane of a perspective camera has to lie before the eye; float depths have no digits
/// for planes nearer than this.
constexpr double least_near = 1e-6;  // of far

Mat4 from_rows(const glm::dvec4& a, const glm::dvec4& b, const glm::dvec4& c, const glm::dvec4& d) {
  return glm::transpose(Mat4(a, b, c, d));
}

Mat4 view_matrix(const scene::CameraFrame& frame) {
  const auto row = [&](const Vec3& axis) { return glm::dvec4(axis, -glm::dot(axis, frame.eye)); };
  return from_rows(row(frame.right), row(frame.up), row(-frame.forward), {0, 0, 0, 1});
}

Mat4 projection_matrix(const scene::Camera& camera, const CameraMatrices& m) {
  const double y = 1 / scene::half_height(camera), x = y / m.aspect;
  const double depth = m.far - m.near;
  if (camera.projection == scene::Projection::orthographic)
    return from_rows({x, 0, 0, 0}, {0, y, 0, 0}, {0, 0, -2 / depth, -(m.far + m.near) / depth},
                     {0, 0, 0, 1});
  return from_rows({x, 0, 0, 0}, {0, y, 0, 0},
                   {0, 0, -(m.far + m.near) / depth, -2 * m.far * m.near / depth}, {0, 0, -1, 0});
}

}  // namespace

CameraMatrices camera_matrices(const scene::Scene& scene, const scene::DepthRange& depths) {
  CameraMatrices m;
  m.aspect = double(scene.width) / scene.height;
  const double margin = std::max(1e-2 * (depths.far - depths.near), 1e-3 * depths.far);
  m.far = depths.far + margin;
  m.near = std::max(depths.near - margin, depths.near / 2);
  if (scene.camera.projection == scene::Projection::perspective)
    m.near = std::max(m.near, least_near * m.far);
  m.view = view_matrix(scene::camera_frame(scene.camera));
  m.projection = projection_matrix(scene.camera, m);
  return m;
}

}  // namespace pellucid::compare
