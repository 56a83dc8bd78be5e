// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/parallel.h"
#include "scene/datasets/dataset.h"
#include "scene/datasets/stand_in.h"

// Particles in a cloud-topped boundary layer over a square of ground: they fill the layer evenly,
// since air hardly compresses, and move by its thermals. A thermal is a column of radius R that
// rises fastest at a third of its height z1 (Lenschow and Stephens 1980, "The role of thermals in
// the convective boundary layer", Eq. 1, for the profile's form: (z/z1)^(1/3) (1 - 1.1 z/z1)),
// Gaussian across; between thermals the air sinks.

namespace pellucid::scene {
namespace {

struct CtblOptions {
  static constexpr std::string_view unit = "points";
  std::size_t count = 3'700'000;
  std::uint64_t seed = 1;
};

constexpr std::size_t thermal_count = 40;
const Box3 layer{Vec3(-1, -1, 0), Vec3(1, 1, 0.5)};

struct Thermal {
  Vec2 center{0}, lean{0};  // the axis is at center + lean z
  double radius = 0, height = 0, speed = 0;
};

Thermal make_thermal(const IndexedRandom& random) {
  const Vec3 place = random.in_box(0, layer);
  return {Vec2(place), Vec2(random.uniform(3, -0.3, 0.3), random.uniform(4, -0.3, 0.3)),
          random.uniform(5, 0.04, 0.12), random.uniform(6, 0.25, 0.5), random.uniform(7, 0.5, 1)};
}

double updraft(const std::vector<Thermal>& thermals, const Vec3& x) {
  double w = -0.05;
  for (const Thermal& thermal : thermals) {
    const Vec2 r = Vec2(x) - thermal.center - thermal.lean * x.z;
    const double h = x.z / thermal.height;
    if (h < 1 / 1.1)
      w += thermal.speed * std::cbrt(h) * (1 - 1.1 * h) *
           std::exp(-glm::dot(r, r) / (thermal.radius * thermal.radius));
  }
  return w;
}

Dataset make(const Parameters& parameters, const Progress&) {
  const CtblOptions options = stand_in_options<CtblOptions>().read(parameters);
  const auto thermals = make_elements(thermal_count, options.seed ^ 0x746865726d0000, make_thermal);
  geometry::PointSet set;
  set.positions = make_elements(options.count, options.seed, [](const IndexedRandom& random) {
    return random.in_box(0, layer);
  });
  std::vector<double> w(set.positions.size());
  parallel_for(std::size_t(0), w.size(),
               [&](std::size_t i) { w[i] = updraft(thermals, set.positions[i]); });
  set_importance("updraft", std::move(w), {.none = 0.9, .full = 0.995}, set);
  return set;
}

}  // namespace

const DatasetRow& ctbl_dataset() {
  static const DatasetRow row{
      .name = "ctbl",
      .title = "Particles of a cloud-topped boundary layer (stand-in: thermals)",
      .citation = "in place of Stevens et al. 2013; profile: Lenschow and Stephens 1980",
      .parameters = stand_in_options<CtblOptions>().specs(),
      .make = make};
  return row;
}

}  // namespace pellucid::scene
