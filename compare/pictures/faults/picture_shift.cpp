// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/pictures/faults/picture_shift.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "compare/pictures/faults/registration.h"

namespace pellucid::compare {
namespace {

double visible(const Image& image, std::size_t i, const Vec3& background) {
  const Vec3 off = glm::abs(Vec3(image.pixels[i]) - background);
  return std::max({off.r, off.g, off.b});
}

/// Whether nothing is covered as far around as shifts are looked for.
bool is_far_from_covered(const Image& reference, int x, int y) {
  constexpr int around = farthest_shift + 1;
  for (int j = std::max(0, y - around); j <= std::min(reference.height - 1, y + around); ++j)
    for (int i = std::max(0, x - around); i <= std::min(reference.width - 1, x + around); ++i)
      if (reference.at(i, j).a > 0) return false;
  return true;
}

bool is_of_8_bits(const Image& image) {
  constexpr float near = 0.01f;  // of a step
  return std::ranges::all_of(image.pixels, [](const Rgba& p) {
    const glm::vec3 steps = 255.f * glm::vec3(p);
    return glm::all(glm::lessThan(glm::abs(steps - glm::round(steps)), glm::vec3(near)));
  });
}

/// By what a test's uncovered pixel may differ from the background: what it does far from anything
/// covered, or as storing it rounds.
double unseen(const Image& reference, const Image& test, const Vec3& background) {
  constexpr double of_floats = 3e-4, of_8_bits = 1.01 / 255;  // half floats among them
  std::vector<double> off;
  for (int y = 0; y < test.height; ++y)
    for (int x = 0; x < test.width; ++x)
      if (is_far_from_covered(reference, x, y))
        off.push_back(
            visible(test, std::size_t(y) * std::size_t(test.width) + std::size_t(x), background));
  const double stored = is_of_8_bits(test) ? of_8_bits : of_floats;
  if (off.empty()) return stored;
  const auto quantile = off.begin() + std::ptrdiff_t(0.99 * double(off.size() - 1));
  std::ranges::nth_element(off, quantile);
  return std::max(stored, 1.5 * *quantile);
}

/// 1 where something is covered. A layer of the reference that is hardly to be seen may not be so
/// in a right test.
RasterPairs coverage_of(const Image& reference, const Image& test, const Vec3& background) {
  constexpr double surely = 3;
  const double least = unseen(reference, test, background);
  const Raster<double> none(test.width, test.height);
  RasterPairs pairs{{{none, none}}, {none}, 1};
  for (std::size_t i = 0; i < test.pixels.size(); ++i) {
    const bool covered = reference.pixels[i].a > 0;
    pairs.reference[0].values.pixels[i] = covered;
    pairs.reference[0].weights.pixels[i] =
        !covered || visible(reference, i, background) > surely * least;
    pairs.test[0].pixels[i] = visible(test, i, background) > least;
  }
  return pairs;
}

/// Of large pictures a part of the pixels tells as much, in less time.
RasterPairs colors_of(const Image& reference, const Image& test) {
  constexpr double enough_pixels = 0x1p17;
  const Raster<double> none(test.width, test.height);
  RasterPairs pairs{std::vector<KnownRaster>(3, {none, none}), std::vector<Raster<double>>(3, none),
                    1};
  pairs.stride = std::max(1, int(std::sqrt(double(test.pixels.size()) / enough_pixels)));
  for (std::size_t c = 0; c < 3; ++c) {
    std::ranges::fill(pairs.reference[c].weights.pixels, 1);
    for (std::size_t i = 0; i < test.pixels.size(); ++i) {
      pairs.reference[c].values.pixels[i] = double(reference.pixels[i][int(c)]);
      pairs.test[c].pixels[i] = double(test.pixels[i][int(c)]);
    }
  }
  return pairs;
}

/// What undoing a shift leaves of the mean square error, in binary pictures whose edges lie
/// anywhere between pixels: a shift by s changes a share s of the pixels at an edge, and drawing
/// them between pixels, its fraction f off, leaves f (1 - f).
double left_by_drawing(const RasterPairs& pairs, const Vec2& shift) {
  const glm::dmat2 edges = step_at(pairs, Vec2(0)).normal;
  double left = 0, changed = 0;
  for (int axis = 0; axis < 2; ++axis) {
    const double by = std::abs(shift[axis]), fraction = by - std::floor(by);
    left += edges[axis][axis] * fraction * (1 - fraction);
    changed += edges[axis][axis] * by;
  }
  return changed > 0 ? left / changed : 1;
}

/// The shift, where undoing it leaves hardly more of the mean square error than drawing does: what
/// is turned, or of another field of view, is nearest somewhere, too, but remains apart.
std::optional<Vec2> found(const RasterPairs& pairs) {
  constexpr double more = 0.2;  // thin lines and layers that a method has elsewhere leave 0.15
  if (apart(pairs, Vec2(0)) == 0) return std::nullopt;
  const std::optional<Vec2> shift = registered_shift(pairs);
  if (!shift) return std::nullopt;
  const double most_left = left_by_drawing(pairs, *shift) + more;
  if (!(apart(pairs, *shift) < most_left * apart(pairs, Vec2(0)))) return std::nullopt;
  return shift;
}

/// How many pixels of edges the reference has, of the direction that has fewer: each has a gradient
/// of 1/2, on either side.
double edges_of(const RasterPairs& coverage) {
  const RegistrationStep step = step_at(coverage, Vec2(0));
  return 2 * std::min(step.normal[0][0], step.normal[1][1]);
}

/// Of least squares.
double uncertainty_of(const RegistrationStep& step) {
  const glm::dmat2 inverse = glm::inverse(step.normal);
  return std::sqrt(step.squares / step.count * std::max(inverse[0][0], inverse[1][1]));
}

}  // namespace

std::optional<Shift> picture_shift(const Image& reference, const Image& test,
                                   const Vec3& background) {
  constexpr double enough_edges = 16;
  if (std::min(test.width, test.height) <= 2 * farthest_shift) return std::nullopt;
  const RasterPairs coverage = coverage_of(reference, test, background);
  if (const double edges = edges_of(coverage); edges >= enough_edges) {
    const std::optional<Vec2> shift = found(coverage);
    if (!shift) return std::nullopt;
    return Shift{shift->x, shift->y, 0.5 / std::sqrt(edges)};
  }
  const RasterPairs colors = colors_of(reference, test);
  const std::optional<Vec2> shift = found(colors);
  if (!shift) return std::nullopt;
  return Shift{shift->x, shift->y, uncertainty_of(step_at(colors, *shift))};
}

}  // namespace pellucid::compare
