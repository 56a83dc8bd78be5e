// SPDX-License-Identifier: GPL-3.0-or-later
// A second, independent path to every crossing: CGAL's exact intersection of the same rays with the
// same triangles by brute force. Where the finder perturbs a ray symbolically, this path moves it
// by a number so small that only exact arithmetic tells it from zero.

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/intersections.h>
#include <gtest/gtest.h>

#include <set>

#include "groundtruth/traversal/crossing_finder.h"
#include "scene/view_depth.h"
#include "tests/support/scenes.h"

namespace pellucid::groundtruth {
namespace {

using namespace testing;
using Number = CGAL::Exact_rational;
using Kernel = CGAL::Simple_cartesian<Number>;
using Point = Kernel::Point_3;
using Triangles = std::set<std::pair<std::uint32_t, std::uint32_t>>;  // object, triangle

Point exact_point(const Vec3& x) { return {Number(x.x), Number(x.y), Number(x.z)}; }

/// 2^-200: far below any difference that these scenes' doubles can have, squared included.
Number tiny() { return Number(0x1p-100) * Number(0x1p-100); }

Kernel::Ray_3 exact_ray(const PictureRay& ray) {
  const Number x = Number(ray.x) + tiny(), y = Number(ray.y) - tiny() * tiny();
  if (ray.projection == scene::Projection::perspective) return {Point(0, 0, 0), Point(x, y, 1)};
  return {Point(x, y, 0), Point(x, y, 1)};
}

/// False when the triangle lies wholly to one side of the ray by a margin that rounding cannot
/// reach.
bool is_near(const PictureRay& ray, const Vec3& a, const Vec3& b, const Vec3& c) {
  const bool perspective = ray.projection == scene::Projection::perspective;
  Box3 box;
  for (const Vec3& v : {a, b, c}) {
    const double depth = perspective ? v.z : 1;
    box.extend({v.x - ray.x * depth, v.y - ray.y * depth, 0});
  }
  constexpr double margin = 1e-3;
  return box.min.x < margin && box.max.x > -margin && box.min.y < margin && box.max.y > -margin;
}

/// Crossings by brute force.
Triangles brute_force(const scene::Scene& scene, const ViewFrame& frame, const PictureRay& ray) {
  Triangles found;
  const Kernel::Ray_3 line = exact_ray(ray);
  for (std::uint32_t o = 0; o < scene.objects.size(); ++o) {
    const geometry::TriangleMesh& mesh = scene.objects[o].mesh();
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto corner = [&](int k) {
        return frame.from_world(mesh.positions[mesh.triangles[t][k]]);
      };
      const Vec3 a = corner(0), b = corner(1), c = corner(2);
      if (!is_near(ray, a, b, c)) continue;
      const Kernel::Triangle_3 triangle(exact_point(a), exact_point(b), exact_point(c));
      if (!triangle.is_degenerate() && CGAL::do_intersect(line, triangle)) found.insert({o, t});
    }
  }
  return found;
}

Triangles by_finder(const CrossingFinder& finder, const PictureRay& ray) {
  std::vector<Crossing> crossings;
  finder.find(ray, crossings);
  Triangles found;
  for (const Crossing& crossing : crossings) found.insert({crossing.object, crossing.primitive});
  EXPECT_EQ(found.size(), crossings.size()) << "a triangle is crossed twice";
  return found;
}

/// A ray through a world point.
PictureRay ray_at(const scene::Scene& scene, const Vec3& x) {
  const scene::CameraFrame frame = scene::camera_frame(scene.camera);
  const double scale =
      scene.camera.projection == scene::Projection::perspective ? scene::view_depth(frame, x) : 1.0;
  const double pixel = 2 * scene::half_height(scene.camera) / scene.height * scale;
  return ViewFrame(scene).ray(scene.width / 2.0 + glm::dot(frame.right, x - frame.eye) / pixel,
                              scene.height / 2.0 - glm::dot(frame.up, x - frame.eye) / pixel);
}

std::vector<PictureRay> rays_of(const scene::Scene& scene) {
  std::vector<PictureRay> rays;
  const ViewFrame frame(scene);
  for (int y = 0; y < scene.height; ++y)
    for (int x = 0; x < scene.width; ++x) rays.push_back(frame.ray(x + 0.5, y + 0.5));
  for (const scene::SceneObject& object : scene.objects) {
    const geometry::TriangleMesh& mesh = object.mesh();
    for (const Vec3& vertex : mesh.positions) rays.push_back(ray_at(scene, vertex));
    for (const auto& triangle : mesh.triangles)
      rays.push_back(
          ray_at(scene, 0.5 * (mesh.positions[triangle[0]] + mesh.positions[triangle[1]])));
  }
  return rays;
}

/// A sheet of n × n cells over [-1, 1]², moved by `shift` in x and y, at z ± wave.
geometry::TriangleMesh sheet(std::uint32_t n, double z, double wave, double shift = 0) {
  geometry::TriangleMesh mesh;
  for (std::uint32_t j = 0; j <= n; ++j)
    for (std::uint32_t i = 0; i <= n; ++i)
      mesh.positions.push_back(
          {2.0 * i / n - 1 + shift, 1 - 2.0 * j / n + shift, z + wave * std::sin(i + 2.0 * j)});
  for (std::uint32_t j = 0; j < n; ++j)
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t v = (n + 1) * j + i;
      mesh.triangles.push_back({v, v + 1, v + n + 2});
      mesh.triangles.push_back({v, v + n + 2, v + n + 1});
    }
  return mesh;
}

/// Triangles a thousand to a billion times as long as wide.
geometry::TriangleMesh slivers() {
  geometry::TriangleMesh mesh = random_triangles(60, 5);
  for (std::uint32_t t = 0; t < 60; ++t) {
    const double width = std::pow(10.0, -3 - double(t % 7));
    mesh.positions[3 * t + 2] =
        mesh.positions[3 * t] + (mesh.positions[3 * t + 2] - mesh.positions[3 * t]) * width;
  }
  return mesh;
}

struct Case {
  const char* name;
  std::vector<geometry::TriangleMesh> meshes;
};

class AgreementExactKernel
    : public ::testing::TestWithParam<std::tuple<std::size_t, scene::Projection>> {
 public:
  static std::vector<Case> cases() {
    return {{"random", {random_triangles(60, 3)}},
            // shifted by half a pixel, exactly: grid lines run through the pixels' centres
            {"aligned", {sheet(16, 0.25, 0, 1.0 / 16), sheet(8, -0.25, 0, 1.0 / 16)}},
            {"wavy", {sheet(8, 0, 0.1)}},
            {"slivers", {slivers()}},
            {"coplanar", {sheet(4, 0, 0), sheet(6, 0, 0)}},
            {"sphere", {sphere(2, Rgba(1))}}};
  }
};

TEST_P(AgreementExactKernel, FindsTheSameCrossings) {
  const auto& [index, projection] = GetParam();
  scene::Scene scene;
  scene.width = scene.height = 16;
  scene.camera = {.projection = projection, .eye = {0, 0, 4}, .fov = 30, .height = 2};
  const Case chosen = cases()[index];
  for (const geometry::TriangleMesh& mesh : chosen.meshes) scene.objects.push_back({"", mesh});
  const CrossingFinder finder(scene, Precision::exact);
  std::size_t crossings = 0;
  for (const PictureRay& ray : rays_of(scene)) {
    const Triangles expected = brute_force(scene, finder.frame(), ray);
    ASSERT_EQ(by_finder(finder, ray), expected) << ray.x << " " << ray.y;
    crossings += expected.size();
  }
  EXPECT_GT(crossings, 40u) << "the rays miss the scene";
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, AgreementExactKernel,
    ::testing::Combine(::testing::Range<std::size_t>(0, 6),
                       ::testing::Values(scene::Projection::perspective,
                                         scene::Projection::orthographic)),
    [](const auto& parameters) {
      return std::string(AgreementExactKernel::cases()[std::get<0>(parameters.param)].name) +
             (std::get<1>(parameters.param) == scene::Projection::perspective ? "_perspective"
                                                                              : "_orthographic");
    });

}  // namespace
}  // namespace pellucid::groundtruth
