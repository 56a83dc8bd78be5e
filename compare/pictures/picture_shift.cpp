// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/pictures/picture_shift.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace pellucid::compare {
namespace {

constexpr int farthest = 4;  // pixels

/// A Layer is a number of every pixel, and how much it may be asked: 0 or 1.
struct Layer {
  Raster<double> values, weights;
};

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

/// Layers of the reference and of the test, of the same quantities; of each row and column so many
/// pixels are one that counts.
struct Pairs {
  std::vector<Layer> reference;
  std::vector<Raster<double>> test;
  int stride = 1;
};

/// Calls visit(reference's layer, its place, the test's value) wherever both are known.
template <class Visit>
void for_each_known(const Pairs& pairs, const Vec2& shift, const Visit& visit) {
  for (std::size_t k = 0; k < pairs.test.size(); ++k) {
    const Raster<double>& test = pairs.test[k];
    const Layer& reference = pairs.reference[k];
    for (int y = farthest; y + farthest < test.height; y += pairs.stride)
      for (int x = farthest; x + farthest < test.width; x += pairs.stride) {
        const Vec2 from = Vec2(x, y) - shift;
        if (between(reference.weights, from) == 1) visit(reference.values, from, test.at(x, y));
      }
  }
}

/// The mean square of what differs.
double apart(const Pairs& pairs, const Vec2& shift) {
  double sum = 0, count = 0;
  for_each_known(pairs, shift, [&](const Raster<double>& reference, const Vec2& from, double is) {
    const double off = is - between(reference, from);
    sum += off * off;
    ++count;
  });
  return count > 0 ? sum / count : std::numeric_limits<double>::infinity();
}

/// The same of whole pixels, without the interpolation that would find their centres.
double apart_by(const Pairs& pairs, int dx, int dy) {
  double sum = 0, count = 0;
  for (std::size_t k = 0; k < pairs.test.size(); ++k) {
    const Raster<double>& test = pairs.test[k];
    const Layer& reference = pairs.reference[k];
    for (int y = farthest; y + farthest < test.height; y += pairs.stride)
      for (int x = farthest; x + farthest < test.width; x += pairs.stride) {
        const double off = test.at(x, y) - reference.values.at(x - dx, y - dy);
        const double weight = reference.weights.at(x - dx, y - dy);
        sum += weight * off * off;
        count += weight;
      }
  }
  return count > 0 ? sum / count : std::numeric_limits<double>::infinity();
}

Vec2 best_whole_shift(const Pairs& pairs) {
  Vec2 best(0);
  double least = apart_by(pairs, 0, 0);
  for (int y = -farthest; y <= farthest; ++y)
    for (int x = -farthest; x <= farthest; ++x)
      if (const double here = apart_by(pairs, x, y); here < least) {
        least = here;
        best = {x, y};
      }
  return best;
}

/// A Step is that of Gauss and Newton for test(x) - reference(x - shift).
struct Step {
  glm::dmat2 normal{0};  // Σ g gᵀ
  Vec2 right{0};
  double squares = 0, count = 0;  // of what differs

  bool is_determined() const { return glm::determinant(normal) > 1e-12; }
};

Step step_at(const Pairs& pairs, const Vec2& shift) {
  Step step;
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

/// Least squares from the best whole pixels on, until they converge; nothing where they leave what
/// was searched.
std::optional<Vec2> converged(const Pairs& pairs) {
  constexpr int most_steps = 20;
  constexpr double done = 1e-3;  // pixels
  Vec2 shift = best_whole_shift(pairs);
  for (int i = 0; i < most_steps; ++i) {
    const Step step = step_at(pairs, shift);
    if (!step.is_determined()) return std::nullopt;
    const Vec2 by = glm::inverse(step.normal) * step.right;
    shift += by;
    if (std::max(std::abs(shift.x), std::abs(shift.y)) > farthest) return std::nullopt;
    if (std::max(std::abs(by.x), std::abs(by.y)) < done) break;
  }
  return shift;
}

double visible(const Image& image, std::size_t i, const Vec3& background) {
  const Vec3 off = glm::abs(Vec3(image.pixels[i]) - background);
  return std::max({off.r, off.g, off.b});
}

/// Whether nothing is covered as far around as shifts are looked for.
bool is_far_from_covered(const Image& reference, int x, int y) {
  constexpr int around = farthest + 1;
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
Pairs coverage_of(const Image& reference, const Image& test, const Vec3& background) {
  constexpr double surely = 3;
  const double least = unseen(reference, test, background);
  const Raster<double> none(test.width, test.height);
  Pairs pairs{{{none, none}}, {none}, 1};
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
Pairs colors_of(const Image& reference, const Image& test) {
  constexpr double enough_pixels = 0x1p17;
  const Raster<double> none(test.width, test.height);
  Pairs pairs{std::vector<Layer>(3, {none, none}), std::vector<Raster<double>>(3, none), 1};
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

/// The shift, where undoing it leaves no more than this share of the mean square error. Of edges
/// that are sampled half a pixel aside half remains when they are drawn between pixels, and 0.7 at
/// a distance of 0.3.
std::optional<Vec2> found(const Pairs& pairs, double most_left) {
  if (apart_by(pairs, 0, 0) == 0) return std::nullopt;
  const std::optional<Vec2> shift = converged(pairs);
  if (!shift || !(apart(pairs, *shift) < most_left * apart(pairs, Vec2(0)))) return std::nullopt;
  return shift;
}

/// How many pixels of edges the reference has, of the direction that has fewer: each has a gradient
/// of 1/2, on either side.
double edges_of(const Pairs& coverage) {
  const Step step = step_at(coverage, Vec2(0));
  return 2 * std::min(step.normal[0][0], step.normal[1][1]);
}

/// Of least squares.
double uncertainty_of(const Step& step) {
  const glm::dmat2 inverse = glm::inverse(step.normal);
  return std::sqrt(step.squares / step.count * std::max(inverse[0][0], inverse[1][1]));
}

}  // namespace

std::optional<Shift> picture_shift(const Image& reference, const Image& test,
                                   const Vec3& background) {
  constexpr double enough_edges = 16, of_coverage = 0.85, of_colors = 0.7;
  if (std::min(test.width, test.height) <= 2 * farthest) return std::nullopt;
  const Pairs coverage = coverage_of(reference, test, background);
  if (const double edges = edges_of(coverage); edges >= enough_edges) {
    const std::optional<Vec2> shift = found(coverage, of_coverage);
    if (!shift) return std::nullopt;
    return Shift{shift->x, shift->y, 0.5 / std::sqrt(edges)};
  }
  const Pairs colors = colors_of(reference, test);
  const std::optional<Vec2> shift = found(colors, of_colors);
  if (!shift) return std::nullopt;
  return Shift{shift->x, shift->y, uncertainty_of(step_at(colors, *shift))};
}

}  // namespace pellucid::compare
