// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/view/pixel_samples.h"

#include <fmt/format.h>

namespace pellucid::scene {
namespace {

/// The digits of `index` to the base, mirrored at the point: in (0, 1) for index ≥ 1.
double radical_inverse(int index, int base) {
  double inverse = 0, place = 1.0 / base;
  for (; index > 0; index /= base, place /= base) inverse += index % base * place;
  return inverse;
}

}  // namespace

std::vector<Vec2> pixel_samples(const PixelSampling& sampling) {
  std::vector<Vec2> samples;
  for (int i = 1; i <= sampling.frames; ++i)
    samples.emplace_back(radical_inverse(i, 2), radical_inverse(i, 3));
  if (sampling.frames > 0) return samples;
  const int n = sampling.per_axis;
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) samples.emplace_back((x + 0.5) / n, (y + 0.5) / n);
  return samples;
}

std::string describe(const PixelSampling& sampling) {
  if (sampling.is_center()) return "one sample at each pixel's centre";
  if (sampling.frames > 0)
    return fmt::format("the mean of {} frames, the camera moved within the pixel", sampling.frames);
  return fmt::format("{0} x {0} samples per pixel, their mean", sampling.per_axis);
}

}  // namespace pellucid::scene
