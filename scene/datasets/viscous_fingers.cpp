// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/parallel.h"
#include "scene/datasets/dataset.h"
#include "scene/datasets/stand_in.h"

// A layer of salt dissolves at the top of a cylinder of water and sinks in fingers: each is a
// column, Gaussian across, that thins towards its tip. Points fill the cylinder evenly; the
// importance is the concentration of salt.

namespace pellucid::scene {
namespace {

struct ViscousFingersOptions {
  static constexpr std::string_view unit = "points";
  std::size_t count = 1'700'000;
  std::uint64_t seed = 1;
};

constexpr std::size_t finger_count = 60;
constexpr double height = 2, layer_depth = 0.08;

struct Finger {
  Vec2 center{0};
  double radius = 0, length = 0, phase = 0;
};

Vec2 in_disc(const IndexedRandom& random, std::uint64_t channel) {
  const double r = std::sqrt(random.uniform(channel));
  const double phi = 2 * std::numbers::pi * random.uniform(channel + 1);
  return {r * std::cos(phi), r * std::sin(phi)};
}

Finger make_finger(const IndexedRandom& random) {
  return {0.92 * in_disc(random, 0), random.uniform(2, 0.03, 0.07), random.uniform(3, 0.4, 1.8),
          random.uniform(4, 0, 2 * std::numbers::pi)};
}

double concentration(const std::vector<Finger>& fingers, const Vec3& x) {
  const double depth = height - x.z;
  double c = std::exp(-depth * depth / (layer_depth * layer_depth));
  for (const Finger& finger : fingers) {
    const double s = depth / finger.length;
    if (s >= 1) continue;
    const Vec2 sway =
        0.03 * s * Vec2(std::cos(finger.phase + 4 * s), std::sin(finger.phase + 4 * s));
    const Vec2 r = Vec2(x) - finger.center - sway;
    const double width = finger.radius * std::sqrt(1 - s);
    c += (1 - 0.5 * s) * std::exp(-glm::dot(r, r) / (width * width));
  }
  return c;
}

Dataset make(const Parameters& parameters, const Progress&) {
  const ViscousFingersOptions options = stand_in_options<ViscousFingersOptions>().read(parameters);
  const auto fingers = make_elements(finger_count, options.seed ^ 0x66696e67657200, make_finger);
  geometry::PointSet set;
  set.positions = make_elements(options.count, options.seed, [](const IndexedRandom& random) {
    return Vec3(in_disc(random, 0), random.uniform(2, 0, height));
  });
  std::vector<double> c(set.positions.size());
  parallel_for(std::size_t(0), c.size(),
               [&](std::size_t i) { c[i] = concentration(fingers, set.positions[i]); });
  set_importance("concentration", std::move(c), {.none = 0.8, .full = 0.97}, set);
  return set;
}

}  // namespace

const DatasetRow& viscous_fingers_dataset() {
  static const DatasetRow row{
      .name = "viscous-fingers",
      .title = "Salt that dissolves in a cylinder of water (stand-in: sinking columns)",
      .citation = "in place of Kuhnert et al. 2016, IEEE SciVis Contest",
      .parameters = stand_in_options<ViscousFingersOptions>().specs(),
      .make = make};
  return row;
}

}  // namespace pellucid::scene
