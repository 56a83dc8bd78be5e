// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/mesh/mesh_samples.h"

#include <algorithm>

namespace pellucid::integrators {
namespace {

constexpr std::array<std::array<double, 3>, 4> places = {
    {{1. / 3, 1. / 3, 1. / 3}, {0.5, 0.5, 0}, {0, 0.5, 0.5}, {0.5, 0, 0.5}}};

double twice_area(const geometry::TriangleMesh& mesh, std::size_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  const Vec3& x = mesh.positions[a];
  return glm::length(glm::cross(mesh.positions[b] - x, mesh.positions[c] - x));
}

}  // namespace

std::vector<MeshSample> sample_mesh(const geometry::TriangleMesh& mesh, std::uint64_t samples) {
  std::vector<double> end_areas(mesh.triangles.size());
  double total = 0;
  for (std::size_t i = 0; i < end_areas.size(); ++i) end_areas[i] = total += twice_area(mesh, i);
  std::vector<MeshSample> chosen;
  if (samples >= mesh.triangles.size() * places.size()) {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
      for (const auto& place : places)
        chosen.push_back({i, place, twice_area(mesh, i) / (total * double(places.size()))});
    return chosen;
  }
  // Each stands for the same area: a few long triangles across a gap matter as much as they show.
  for (std::uint64_t i = 0; i < samples; ++i) {
    const double area = (double(i) + 0.5) / double(samples) * total;
    const auto triangle = std::upper_bound(end_areas.begin(), end_areas.end() - 1, area);
    chosen.push_back({std::size_t(triangle - end_areas.begin()), places[i % places.size()],
                      1 / double(samples)});
  }
  return chosen;
}

Vec3 position_of(const geometry::TriangleMesh& mesh, const MeshSample& sample) {
  Vec3 x(0);
  for (std::size_t k = 0; k < 3; ++k)
    x += sample.barycentric[k] * mesh.positions[mesh.triangles[sample.triangle][k]];
  return x;
}

}  // namespace pellucid::integrators
