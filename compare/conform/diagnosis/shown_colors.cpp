// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "compare/conform/diagnosis/diagnose.h"
#include "compare/conform/diagnosis/explanations.h"
#include "compare/pictures/given_faults.h"
#include "compare/pictures/srgb.h"

namespace pellucid::compare {
namespace {

std::optional<Explanation> over(const WrongPixels& pixels, const Vec3& color) {
  const auto is_over = [&](std::size_t i) {
    return pixels.is(i, composite_of(pixels.layers(i), color), 4 * pixels.tolerance());
  };
  if (!pixels.explains(is_over)) return std::nullopt;
  const Vec3& right = pixels.behind();
  return Explanation{
      Fault::background,
      fmt::format("({:.3g}, {:.3g}, {:.3g}) shows through, not ({:.3g}, {:.3g}, {:.3g})", color.r,
                  color.g, color.b, right.r, right.g, right.b)};
}

/// The colour behind is that of the pixel through which most of it shows, where others, through
/// which less does, can confirm it.
std::optional<Vec3> color_behind(const WrongPixels& pixels) {
  constexpr double enough = 0.02;  // to tell the colour by
  const auto left = [&](std::size_t i) {
    return 1 - composite_of(pixels.layers(i), pixels.behind()).a;
  };
  const std::size_t clearest = *std::ranges::max_element(pixels.wrong(), {}, left);
  const double most = left(clearest);
  if (most < enough) return std::nullopt;
  const glm::dvec4 own = composite_of(pixels.layers(clearest), Vec3(0));
  const Vec3 color = (Vec3(pixels.shown(clearest)) - Vec3(own)) / most;
  const Vec3 possible = glm::clamp(color, Vec3(0), Vec3(1));
  const Vec3 uncertain(4 * pixels.tolerance() / most);
  if (glm::any(glm::greaterThan(glm::abs(color - possible), uncertain))) return std::nullopt;
  const bool is_confirmed =
      std::ranges::any_of(pixels.wrong(), [&](std::size_t i) { return left(i) < most - enough; });
  return is_confirmed || most > 0.999 ? std::optional(possible) : std::nullopt;
}

}  // namespace

/// Mostly it is black or white.
std::optional<Explanation> over_another_background(const WrongPixels& pixels) {
  for (const Vec3& color : {Vec3(0), Vec3(1)})
    if (auto found = over(pixels, color)) return found;
  const std::optional<Vec3> color = color_behind(pixels);
  return color ? over(pixels, *color) : std::nullopt;
}

/// Linear values shown as sRGB ones, or the other way round.
std::optional<Explanation> through_a_curve(const WrongPixels& pixels) {
  const auto is_through = [&](double (*curve)(double)) {
    return pixels.is_composite(
        [curve](const Layers& all, const Vec3& background) {
          const glm::dvec4 right = composite_of(all, background);
          return glm::dvec4(curve(right.r), curve(right.g), curve(right.b), right.a);
        },
        2 * pixels.tolerance());
  };
  if (is_through(encoded_as_srgb<double>)) return Explanation{Fault::picture, "encoded as sRGB"};
  if (is_through(decoded_from_srgb<double>))
    return Explanation{Fault::picture, "decoded from sRGB"};
  return std::nullopt;
}

/// In a picture of one colour anything might be seen.
std::optional<Explanation> of_the_picture(const WrongPixels& pixels) {
  const ConformanceCase& c = pixels.conformance_case();
  if (c.layers.size() < 2) return std::nullopt;
  const auto faults = given_faults(expected_picture(c), pixels.picture(), pixels.behind());
  if (faults.empty()) return std::nullopt;
  return Explanation{Fault::picture, fmt::format("{}", fmt::join(faults, "; "))};
}

}  // namespace pellucid::compare
