// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>

#include "core/parallel.h"
#include "scene/datasets/dataset.h"
#include "scene/datasets/stand_in.h"

// The cosmic web. Haloes are drawn at random, each with a mass by a power law; strands join each
// halo to its nearest neighbours. Points gather in haloes (Plummer spheres), along strands (normal
// across) and, a few, everywhere. The density that gives the importance is counted, not assumed.

namespace pellucid::scene {
namespace {

struct DarkSkyOptions {
  static constexpr std::string_view unit = "points";
  std::size_t count = 16'300'000;
  std::uint64_t seed = 1;
};

constexpr std::size_t halo_count = 1500, strands_per_halo = 3;
constexpr double share_in_haloes = 0.3, share_in_strands = 0.5;
const Box3 box{Vec3(-1), Vec3(1)};

struct Halo {
  Vec3 center{0};
  double mass = 0, radius = 0;
};

struct Web {
  std::vector<Halo> haloes;
  std::vector<double> mass_up_to;  // cumulative
  std::vector<std::array<std::size_t, strands_per_halo>> neighbours;
};

Halo make_halo(const IndexedRandom& random) {
  // P(mass > m) ~ 1/m between 1 and 200.
  const double mass = 1 / (1 - random.uniform(3) * (1 - 1.0 / 200));
  return {random.in_box(0, box), mass, 0.006 * std::cbrt(mass)};
}

std::array<std::size_t, strands_per_halo> nearest(const std::vector<Halo>& haloes, std::size_t i) {
  std::vector<std::size_t> others;
  for (std::size_t k = 0; k < haloes.size(); ++k)
    if (k != i) others.push_back(k);
  const auto distance = [&](std::size_t k) {
    return glm::length(haloes[k].center - haloes[i].center);
  };
  std::ranges::partial_sort(others, others.begin() + strands_per_halo, {}, distance);
  std::array<std::size_t, strands_per_halo> found;
  std::copy_n(others.begin(), strands_per_halo, found.begin());
  return found;
}

Web make_web(std::uint64_t seed) {
  Web web;
  // Another stream of random numbers than that of the points.
  web.haloes = make_elements(halo_count, seed ^ 0x77656200000000, make_halo);
  double sum = 0;
  for (const Halo& halo : web.haloes) web.mass_up_to.push_back(sum += halo.mass);
  for (std::size_t i = 0; i < halo_count; ++i) web.neighbours.push_back(nearest(web.haloes, i));
  return web;
}

std::size_t halo_by_mass(const Web& web, double u) {
  const auto& sums = web.mass_up_to;
  return std::size_t(std::upper_bound(sums.begin(), sums.end(), u * sums.back()) - sums.begin());
}

/// Plummer 1911: P(r) = (r² / (r² + a²))^(3/2), cut at 20 a.
Vec3 point_in_halo(const Halo& halo, const IndexedRandom& random) {
  const double p = std::pow(random.uniform(2), 2.0 / 3), cut = 400.0 / 401;
  const double r = halo.radius * std::sqrt(p * cut / (1 - p * cut));
  return halo.center + r * random.direction(3);
}

Vec3 point_on_strand(const Web& web, const IndexedRandom& random) {
  const std::size_t from = halo_by_mass(web, random.uniform(1));
  const std::size_t to = web.neighbours[from][random.below(2, strands_per_halo)];
  const Vec3 a = web.haloes[from].center, b = web.haloes[to].center;
  return glm::mix(a, b, random.uniform(3)) + 0.012 * random.normal3(4);
}

Vec3 make_point(const Web& web, const IndexedRandom& random) {
  const double kind = random.uniform(0);
  if (kind < share_in_haloes)
    return point_in_halo(web.haloes[halo_by_mass(web, random.uniform(1))], random);
  if (kind < share_in_haloes + share_in_strands) return point_on_strand(web, random);
  return random.in_box(1, box);
}

/// The logarithm of the number of points in each point's cell; cells hold four on average.
std::vector<double> log_density(const std::vector<Vec3>& points) {
  Box3 bounds;
  for (const Vec3& x : points) bounds.extend(x);
  const auto n = std::uint32_t(std::clamp(std::cbrt(double(points.size()) / 4), 4.0, 256.0));
  const Vec3 cells_per_unit = double(n) / (bounds.max - bounds.min);
  const auto cell_of = [&](const Vec3& x) {
    const glm::uvec3 c = glm::min(glm::uvec3((x - bounds.min) * cells_per_unit), glm::uvec3(n - 1));
    return (std::size_t(c.z) * n + c.y) * n + c.x;
  };
  std::vector<std::uint32_t> counts(std::size_t(n) * n * n);
  for (const Vec3& x : points) ++counts[cell_of(x)];
  std::vector<double> density(points.size());
  parallel_for(std::size_t(0), points.size(),
               [&](std::size_t i) { density[i] = std::log(counts[cell_of(points[i])]); });
  return density;
}

Dataset make(const Parameters& parameters, const Progress&) {
  const DarkSkyOptions options = stand_in_options<DarkSkyOptions>().read(parameters);
  const Web web = make_web(options.seed);
  geometry::PointSet set;
  set.positions = make_elements(options.count, options.seed, [&](const IndexedRandom& random) {
    return make_point(web, random);
  });
  set_importance("density", log_density(set.positions), {.none = 0.6, .full = 0.99}, set);
  return set;
}

}  // namespace

const DatasetRow& dark_sky_dataset() {
  static const DatasetRow row{
      .name = "dark-sky",
      .title = "Cosmic web of dark matter (stand-in: haloes joined by strands)",
      .citation = "in place of Skillman et al. 2014, Dark Sky simulations",
      .parameters = stand_in_options<DarkSkyOptions>().specs(),
      .make = make};
  return row;
}

}  // namespace pellucid::scene
