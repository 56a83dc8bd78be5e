// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/datasets/dataset.h"

#include <algorithm>
#include <cmath>

#include "scene/datasets/stand_in.h"

// White matter as bundles of arcs in an ellipsoid, x to the right, y to the front, z up. Fibres of
// the corpus callosum leave one hemisphere, cross the middle plane and end in the other:
// important. Association fibres join the front and the back of a hemisphere, projection fibres rise
// from the stem and fan out: context. Each runs along a Bézier curve whose control points are
// jittered, over the part of it that tracking got through: 0.25 to 0.55 of the way from grey matter
// to grey matter, since it ends where bundles meet or anisotropy is low.

namespace pellucid::scene {
namespace {

struct FibresOptions {
  static constexpr std::string_view unit = "lines";
  std::size_t count = 18'000;
  std::uint64_t seed = 1;
};

constexpr int points_per_fibre = 48;
constexpr double share_of_callosum = 0.2, share_of_association = 0.45;

struct Fibre {
  Vec3 p0{0}, p1{0}, p2{0}, p3{0};
  double importance = 0;
  double from = 0, to = 1;  // the part that was tracked

  Vec3 at(double t) const {
    const double s = 1 - t;
    return s * s * s * p0 + 3 * s * s * t * p1 + 3 * s * t * t * p2 + t * t * t * p3;
  }
};

Fibre jittered(Fibre fibre, const IndexedRandom& random) {
  fibre.p0 += 0.05 * random.normal3(10);
  fibre.p1 += 0.05 * random.normal3(16);
  fibre.p2 += 0.05 * random.normal3(22);
  fibre.p3 += 0.05 * random.normal3(28);
  return fibre;
}

/// The part's middle is at most `off_middle` of what there is from the curve's own.
Fibre tracked(Fibre fibre, double off_middle, const IndexedRandom& random) {
  const double length = random.uniform(40, 0.25, 0.55);
  const double off = off_middle * (0.5 - length / 2);
  const double middle = random.uniform(41, 0.5 - off, 0.5 + off);
  fibre.from = middle - length / 2;
  fibre.to = middle + length / 2;
  return fibre;
}

Fibre callosal(const IndexedRandom& random) {
  const double y = random.uniform(1, -0.6, 0.6), reach = random.uniform(2, 0.35, 0.75);
  const double rise = random.uniform(3, 0.3, 0.75) * std::sqrt(1 - y * y);
  return {{-reach, 1.3 * y, rise}, {-0.2, y, 0.05}, {0.2, y, 0.05}, {reach, 1.3 * y, rise}, 1};
}

Fibre associating(const IndexedRandom& random) {
  const double side = random.uniform(1) < 0.5 ? -1 : 1, x = side * random.uniform(2, 0.2, 0.8);
  const double z = random.uniform(3, -0.4, 0.6), bow = random.uniform(4, 0.1, 0.5);
  const double reach = std::sqrt(std::max(0.2, 1.2 - x * x - z * z));
  return {{x, -reach, z}, {1.2 * x, -0.4, z + bow}, {1.2 * x, 0.4, z + bow}, {x, reach, z}, 0};
}

Fibre projecting(const IndexedRandom& random) {
  const double side = random.uniform(1) < 0.5 ? -1 : 1;
  const double phi = random.uniform(2, 0, 2 * std::numbers::pi), fan = random.uniform(3, 0.1, 0.6);
  const Vec3 top(side * 0.4 + fan * std::cos(phi), 1.4 * fan * std::sin(phi),
                 random.uniform(4, 0.5, 0.85));
  return {{side * 0.08, -0.1, -0.9}, {side * 0.15, -0.05, -0.3}, {side * 0.3, 0, 0.1}, top, 0};
}

Fibre make_fibre(const IndexedRandom& random) {
  const double kind = random.uniform(0);
  // Callosal fibres cross the middle plane, so the middle of theirs is tracked.
  if (kind < share_of_callosum) return tracked(jittered(callosal(random), random), 0.3, random);
  if (kind < share_of_callosum + share_of_association)
    return tracked(jittered(associating(random), random), 1, random);
  return tracked(jittered(projecting(random), random), 1, random);
}

Dataset make(const Parameters& parameters, const Progress&) {
  const FibresOptions options = stand_in_options<FibresOptions>().read(parameters);
  const auto fibres = make_elements(options.count, options.seed, make_fibre);
  geometry::LineSet lines;
  std::vector<double> connection;
  for (const Fibre& fibre : fibres) {
    for (int i = 0; i < points_per_fibre; ++i)
      lines.positions.push_back(
          fibre.at(std::lerp(fibre.from, fibre.to, double(i) / (points_per_fibre - 1))));
    lines.offsets.push_back(lines.positions.size());
    connection.insert(connection.end(), points_per_fibre, fibre.importance);
  }
  set_importance("callosal", std::move(connection), {.none = 0, .full = 1}, lines);
  return lines;
}

}  // namespace

// Fibre tracks of a brain: in place of the diffusion data of Baeza Rojo et al. 2019, Fig. 1.
const DatasetRow& dt_mri_dataset() {
  static const DatasetRow row{
      .name = "dt-mri",
      .title = "Fibre tracks of a brain (stand-in: bundles of arcs)",
      .citation = "in place of a diffusion tensor scan, Central Hospital of Bremen",
      .parameters = stand_in_options<FibresOptions>().specs(),
      .make = make};
  return row;
}

}  // namespace pellucid::scene
