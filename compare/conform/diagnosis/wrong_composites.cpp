// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/conform/diagnosis/wrong_composites.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>

namespace pellucid::compare {
namespace {

double rounded(double x, Halfway halfway) {
  constexpr double of_a_step = 1e-4;  // what floats make of a half
  const double way = halfway == Halfway::nearest ? 0
                     : halfway == Halfway::up    ? of_a_step
                                                 : -of_a_step;
  return std::round(std::clamp(x, 0.0, 1.0) * 255 + way) / 255;
}
Vec3 rounded(const Vec3& v, Halfway halfway) {
  return {rounded(v.x, halfway), rounded(v.y, halfway), rounded(v.z, halfway)};
}

double halved(double x) { return glm::unpackHalf1x16(glm::packHalf1x16(float(x))); }
Vec3 halved(const Vec3& v) { return {halved(v.x), halved(v.y), halved(v.z)}; }

/// The sum of the colours weighted by their opacities, and the sum of these.
struct WeightedSum {
  Vec3 color{0};
  double weight = 0;
};

WeightedSum weighted_sum(const Layers& layers) {
  WeightedSum sum;
  for (const Rgba& layer : layers) {
    sum.color += double(layer.a) * Vec3(layer);
    sum.weight += double(layer.a);
  }
  return sum;
}

}  // namespace

glm::dvec4 blended_in_8_bits(const Layers& layers, const Vec3& background, Halfway halfway) {
  Vec3 color = rounded(background, halfway);
  for (auto layer = layers.rbegin(); layer != layers.rend(); ++layer)
    color = rounded(glm::mix(color, Vec3(*layer), double(layer->a)), halfway);
  return {color, 0};
}

glm::dvec4 accumulated_in_8_bits(const Layers& layers, const Vec3& background, Halfway halfway) {
  Vec3 color(0);
  double alpha = 0;
  for (const Rgba& layer : layers) {
    color = rounded(color + (1 - alpha) * double(layer.a) * Vec3(layer), halfway);
    alpha = rounded(alpha + (1 - alpha) * double(layer.a), halfway);
  }
  return {color + (1 - alpha) * background, 0};
}

glm::dvec4 stored_in_8_bits(Layers layers, const Vec3& background, Halfway halfway) {
  for (Rgba& layer : layers)
    layer = Rgba(rounded(Vec3(layer), halfway), rounded(double(layer.a), halfway));
  return composite_of(layers, background);
}

glm::dvec4 opacities_in_8_bits(Layers layers, const Vec3& background, Halfway halfway) {
  for (Rgba& layer : layers) layer.a = float(rounded(double(layer.a), halfway));
  return composite_of(layers, background);
}

glm::dvec4 blended_in_halves(const Layers& layers, const Vec3& background) {
  Vec3 color = halved(background);
  for (auto layer = layers.rbegin(); layer != layers.rend(); ++layer)
    color = halved(glm::mix(color, Vec3(*layer), double(layer->a)));
  return {color, 0};
}

glm::dvec4 stored_in_halves(Layers layers, const Vec3& background) {
  for (Rgba& layer : layers) layer = Rgba(halved(Vec3(layer)), halved(double(layer.a)));
  return composite_of(layers, background);
}

glm::dvec4 rounded_to_halves(const Layers& layers, const Vec3& background) {
  const glm::dvec4 right = composite_of(layers, background);
  return {halved(Vec3(right)), right.a};
}

glm::dvec4 multiplied_again(Layers layers, const Vec3& background) {
  for (Rgba& layer : layers) layer = Rgba(layer.a * glm::vec3(layer), layer.a);
  return composite_of(layers, background);
}

glm::dvec4 blended_again(const Layers& layers, const Vec3& background) {
  const double alpha = composite_of(layers, Vec3(0)).a;
  return {glm::mix(background, Vec3(composite_of(layers, background)), alpha), 0};
}

glm::dvec4 not_multiplied(const Layers& layers, const Vec3& background) {
  Vec3 color(0);
  double transmittance = 1;
  for (const Rgba& layer : layers) {
    color += transmittance * Vec3(layer);
    transmittance *= 1 - double(layer.a);
  }
  return {color + transmittance * background, 0};
}

glm::dvec4 straight(const Layers& layers, const Vec3&) {
  const glm::dvec4 own = composite_of(layers, Vec3(0));
  return {own.a > 0 ? Vec3(own) / own.a : Vec3(own), 0};
}

glm::dvec4 averaged(const Layers& layers, const Vec3& background) {
  const auto [color, weight] = weighted_sum(layers);
  double transmittance = 1;
  for (const Rgba& layer : layers) transmittance *= 1 - double(layer.a);
  const Vec3 mean = weight > 0 ? color / weight : color;
  return {glm::mix(mean, background, transmittance), 0};
}

glm::dvec4 averaged_with_opacity(const Layers& layers, const Vec3& background) {
  const auto [color, weight] = weighted_sum(layers);
  if (!(weight > 0)) return {background, 0};
  const auto n = double(layers.size());
  return {glm::mix(color / weight, background, std::pow(1 - weight / n, n)), 0};
}

glm::dvec4 summed(const Layers& layers, const Vec3& background) {
  const auto [color, weight] = weighted_sum(layers);
  return {color + (1 - weight) * background, 0};
}

}  // namespace pellucid::compare
