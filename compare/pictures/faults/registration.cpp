// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/pictures/faults/registration.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pellucid::compare {
namespace {

double clamped_at(const Raster<double>& raster, int x, int y) {
  return raster.at(std::clamp(x, 0, raster.width - 1), std::clamp(y, 0, raster.height - 1));
}

/// Between pixels' centres, linearly.
double between(const Raster<double>& raster, const Vec2& x) {
  const Vec2 low = glm::floor(x), part = x - low;
  const int i = int(low.x), j = int(low.y);
  const double upper = glm::mix(clamped_at(raster, i, j), clamped_at(raster, i + 1, j), part.x);
  const double lower =
      glm::mix(clamped_at(raster, i, j + 1), clamped_at(raster, i + 1, j + 1), part.x);
  return glm::mix(upper, lower, part.y);
}

Vec2 gradient(const Raster<double>& raster, const Vec2& x) {
  return {(between(raster, x + Vec2(1, 0)) - between(raster, x - Vec2(1, 0))) / 2,
          (between(raster, x + Vec2(0, 1)) - between(raster, x - Vec2(0, 1))) / 2};
}

/// Calls visit(reference's values, its place, the test's value) wherever both are known.
template <class Visit>
void for_each_known(const RasterPairs& pairs, const Vec2& shift, const Visit& visit) {
  constexpr double wholly = 1 - 1e-9;  // known, of all four pixels
  for (std::size_t k = 0; k < pairs.test.size(); ++k) {
    const Raster<double>& test = pairs.test[k];
    const KnownRaster& reference = pairs.reference[k];
    for (int y = farthest_shift; y + farthest_shift < test.height; y += pairs.stride)
      for (int x = farthest_shift; x + farthest_shift < test.width; x += pairs.stride) {
        const Vec2 from = Vec2(x, y) - shift;
        if (between(reference.weights, from) > wholly) visit(reference.values, from, test.at(x, y));
      }
  }
}

/// apart() of whole pixels, without the interpolation that would find their centres.
double apart_by(const RasterPairs& pairs, int dx, int dy) {
  double sum = 0, count = 0;
  for (std::size_t k = 0; k < pairs.test.size(); ++k) {
    const Raster<double>& test = pairs.test[k];
    const KnownRaster& reference = pairs.reference[k];
    for (int y = farthest_shift; y + farthest_shift < test.height; y += pairs.stride)
      for (int x = farthest_shift; x + farthest_shift < test.width; x += pairs.stride) {
        const double off = test.at(x, y) - reference.values.at(x - dx, y - dy);
        const double weight = reference.weights.at(x - dx, y - dy);
        sum += weight * off * off;
        count += weight;
      }
  }
  return count > 0 ? sum / count : std::numeric_limits<double>::infinity();
}

Vec2 best_whole_shift(const RasterPairs& pairs) {
  Vec2 best(0);
  double least = apart_by(pairs, 0, 0);
  for (int y = -farthest_shift; y <= farthest_shift; ++y)
    for (int x = -farthest_shift; x <= farthest_shift; ++x)
      if (const double here = apart_by(pairs, x, y); here < least) {
        least = here;
        best = {x, y};
      }
  return best;
}

}  // namespace

double apart(const RasterPairs& pairs, const Vec2& shift) {
  double sum = 0, count = 0;
  for_each_known(pairs, shift, [&](const Raster<double>& reference, const Vec2& from, double is) {
    const double off = is - between(reference, from);
    sum += off * off;
    ++count;
  });
  return count > 0 ? sum / count : std::numeric_limits<double>::infinity();
}

RegistrationStep step_at(const RasterPairs& pairs, const Vec2& shift) {
  RegistrationStep step;
  for_each_known(pairs, shift, [&](const Raster<double>& reference, const Vec2& from, double is) {
    const Vec2 g = gradient(reference, from);
    const double off = is - between(reference, from);
    step.normal += glm::outerProduct(g, g);
    step.right -= g * off;
    step.squares += off * off;
    ++step.count;
  });
  return step;
}

std::optional<Vec2> registered_shift(const RasterPairs& pairs) {
  constexpr int most_steps = 20;
  constexpr double done = 1e-3;  // pixels
  Vec2 shift = best_whole_shift(pairs);
  for (int i = 0; i < most_steps; ++i) {
    const RegistrationStep step = step_at(pairs, shift);
    if (!step.is_determined()) return std::nullopt;
    const Vec2 by = glm::inverse(step.normal) * step.right;
    shift += by;
    if (std::max(std::abs(shift.x), std::abs(shift.y)) > farthest_shift) return std::nullopt;
    if (std::max(std::abs(by.x), std::abs(by.y)) < done) break;
  }
  return shift;
}

}  // namespace pellucid::compare
