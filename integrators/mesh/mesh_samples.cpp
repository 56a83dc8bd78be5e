// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/mesh/mesh_samples.h"

#include <algorithm>
#include <cmath>

#include "core/indexed_random.h"
#include "integrators/paths/magnitude.h"

namespace pellucid::integrators {
namespace {

constexpr std::array<std::array<double, 3>, 4> places = {
    {{1. / 3, 1. / 3, 1. / 3}, {0.5, 0.5, 0}, {0, 0.5, 0.5}, {0.5, 0, 0.5}}};

double twice_area(const geometry::TriangleMesh& mesh, std::size_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  const Vec3& x = mesh.positions[a];
  return magnitude(glm::cross(mesh.positions[b] - x, mesh.positions[c] - x));
}

/// The i-th of a sequence that covers the triangle evenly: R₂ of M. Roberts, "The Unreasonable
/// Effectiveness of Quasirandom Sequences", 2018, additive with the powers of 1 / g, g³ = g + 1, on
/// the unit square, whose far half is folded onto the near one. Any stretch of it covers evenly.
std::array<double, 3> spread_place(std::uint64_t i) {
  constexpr double g = 1.32471795724474602596;
  double whole;
  double u = std::modf(0.5 + double(i) / g, &whole),
         v = std::modf(0.5 + double(i) / (g * g), &whole);
  if (u + v > 1) u = 1 - u, v = 1 - v;
  return {1 - u - v, u, v};
}

}  // namespace

std::vector<MeshSample> sample_mesh(const geometry::TriangleMesh& mesh, std::uint64_t samples) {
  std::vector<double> end_areas(mesh.triangles.size());
  double total = 0;
  for (std::size_t i = 0; i < end_areas.size(); ++i) end_areas[i] = total += twice_area(mesh, i);
  const bool all_places = samples >= mesh.triangles.size() * places.size();
  std::vector<MeshSample> chosen;
  std::size_t next = 0;  // the first triangle whose places are not chosen yet
  const auto choose_places = [&](std::size_t end) {
    for (; all_places && next < end; ++next)
      for (const auto& place : places) chosen.push_back({next, place, 0});
  };
  // Each stands for the same area: a few long triangles across a gap matter as much as they show.
  // Where in its part of the area is drawn by lot. Triangles come in rows, and even steps, or any
  // lattice's, fall into step with some number of rows: each row would then be looked at in the
  // same few places. Chance does not, whatever the order; what it costs falls with the number's
  // root where triangles are more than the samples, and faster where they are fewer.
  for (std::uint64_t i = 0; i < samples && !end_areas.empty(); ++i) {
    const double area = (double(i) + IndexedRandom(0, i).uniform(0)) / double(samples) * total;
    const auto found = std::upper_bound(end_areas.begin(), end_areas.end() - 1, area);
    const auto triangle = std::size_t(found - end_areas.begin());
    choose_places(triangle + 1);
    chosen.push_back({triangle, spread_place(i), 1 / double(samples)});
    if (!all_places) chosen.push_back({triangle, places[i % places.size()], 0});
  }
  choose_places(mesh.triangles.size());
  return chosen;
}

Vec3 position_of(const geometry::TriangleMesh& mesh, const MeshSample& sample) {
  Vec3 x(0);
  for (std::size_t k = 0; k < 3; ++k)
    x += sample.barycentric[k] * mesh.positions[mesh.triangles[sample.triangle][k]];
  return x;
}

}  // namespace pellucid::integrators
