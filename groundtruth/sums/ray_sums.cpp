// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/sums/ray_sums.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/parallel.h"
#include "groundtruth/shapes/crossing_geometry.h"
#include "groundtruth/sums/front_to_back.h"

namespace pellucid::groundtruth {
namespace {

/// The last layer at a depth up to and with d; null when there is none.
const RayLayer* last_layer(const std::vector<RayLayer>& layers, double d) {
  const auto next = std::upper_bound(layers.begin(), layers.end(), d,
                                     [](double x, const RayLayer& layer) { return x < layer.d; });
  return next == layers.begin() ? nullptr : &*std::prev(next);
}

}  // namespace

double RaySums::importance_sum(double d) const {
  const RayLayer* layer = last_layer(layers, d);
  return layer ? layer->importance_sum : 0;
}

double RaySums::optical_depth(double d) const {
  const RayLayer* layer = last_layer(layers, d);
  return layer ? layer->optical_depth : 0;
}

RayProbe::RayProbe(const scene::Scene& scene, Precision precision)
    : scene_(scene), depths_(scene::depth_range(scene)), finder_(scene, precision) {}

RayProbe::RayProbe(const ScenePart& part)
    : scene_(part.scene),
      depths_(part.whole.depths),
      finder_(part.scene, part.whole, Precision::exact),
      first_primitives_(part.whole.first_primitives) {}

RaySums RayProbe::at(double x, double y) const {
  const PictureRay ray = finder_.frame().ray(x, y);
  std::vector<Crossing> crossings;
  finder_.find(ray, crossings);
  finder_.round_depths(ray, crossings);
  return sums(ray, crossings);
}

std::vector<RaySums> RayProbe::at(std::span<const Vec2> places) const {
  std::vector<RaySums> found(places.size());
  const std::size_t packets = (places.size() + RayPacket::width - 1) / RayPacket::width;
  parallel_for(std::size_t(0), packets, [&](std::size_t packet) {
    thread_local std::array<std::vector<Crossing>, RayPacket::width> crossings;
    const std::size_t first = packet * RayPacket::width;
    std::vector<PictureRay> rays;
    for (const Vec2& place :
         places.subspan(first, std::min(RayPacket::width, places.size() - first)))
      rays.push_back(finder_.frame().ray(place.x, place.y));
    finder_.find(rays, std::span(crossings).first(rays.size()));
    for (std::size_t k = 0; k < rays.size(); ++k) {
      finder_.round_depths(rays[k], crossings[k]);
      found[first + k] = sums(rays[k], crossings[k]);
    }
  });
  return found;
}

RaySums RayProbe::sums(const PictureRay& ray, std::span<const Crossing> crossings) const {
  const Vec3 direction = finder_.frame().world_direction(ray);
  RaySums sums;
  sums.layers.reserve(crossings.size());
  double importance_sum = 0, optical_depth = 0;
  FrontToBack composite;
  for (const Crossing& crossing : crossings) {
    const Fragment fragment = finder_.shade(crossing, direction);
    const double depth = crossing.depth / finder_.frame().units_per_length();
    const double g = finder_.importance(crossing);
    importance_sum += g * g;
    optical_depth -= std::log1p(-fragment.opacity);
    const std::uint32_t first = first_primitives_.empty() ? 0 : first_primitives_[crossing.object];
    sums.layers.push_back({depth, depths_.normalized(depth), crossing.object,
                           first + crossing.primitive, fragment.color, fragment.opacity, g,
                           composite.transmittance, importance_sum, optical_depth});
    composite.add(fragment.color, fragment.opacity);
  }
  sums.color = composite.over(scene_.background);
  sums.transmittance = composite.transmittance;
  return sums;
}

}  // namespace pellucid::groundtruth
