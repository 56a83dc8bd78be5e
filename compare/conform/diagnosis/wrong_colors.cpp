// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>

#include "compare/conform/diagnosis/diagnose.h"
#include "compare/conform/diagnosis/explanations.h"
#include "compare/conform/diagnosis/wrong_composites.h"
#include "compare/pictures/srgb.h"

namespace pellucid::compare {
namespace {

/// The right picture with every channel through a function.
template <class Function>
std::optional<double> left_by_curve(const WrongPixels& pixels, double most, const Function& curve) {
  const auto curved = [&](const Layers& all, const Vec3& background) {
    const glm::dvec4 right = composite_of(all, background);
    return glm::dvec4(curve(right.r), curve(right.g), curve(right.b), right.a);
  };
  return pixels.left_by_composite(curved, most);
}

/// The median, over what is shown of the wrong pixels between black and white, of a parameter that
/// right and shown values tell; nothing where no pixel does.
template <class Parameter>
std::optional<double> fitted(const WrongPixels& pixels, const Parameter& parameter) {
  constexpr float least = 0.05f, most = 0.98f;  // of right values
  const Image right = expected_picture(pixels.conformance_case());
  std::vector<double> values;
  for (const std::size_t i : pixels.wrong())
    for (int c = 0; c < 3; ++c) {
      const float was = right.pixels[i][c], is = pixels.shown(i)[c];
      const bool may_be_clamped = pixels.are_stored_in_8_bits() && is >= 1;
      if (was > least && was < most && is > 0 && !may_be_clamped)
        values.push_back(parameter(double(was), double(is)));
    }
  if (values.empty()) return std::nullopt;
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

void add_exchanged(const WrongPixels& pixels, Explanations& found) {
  const struct {
    int order[3];
    const char* name;
  } orders[] = {{{2, 1, 0}, "BGR"},
                {{1, 0, 2}, "GRB"},
                {{0, 2, 1}, "RBG"},
                {{1, 2, 0}, "GBR"},
                {{2, 0, 1}, "BRG"}};
  for (const auto& [order, name] : orders) {
    const auto exchanged = [&](const Layers& all, const Vec3& background) {
      const glm::dvec4 right = composite_of(all, background);
      return glm::dvec4(right[order[0]], right[order[1]], right[order[2]], right.a);
    };
    add_explanation(found, Fault::colors, fmt::format("channels are exchanged: {} for RGB", name),
                    pixels.left_by_composite(exchanged, pixels.nearly_all()));
  }
}

/// sRGB's curve is nearly a power of 2.2, but not so nearly that the two could not be told apart.
void add_power(const WrongPixels& pixels, Explanations& found) {
  constexpr double least_bend = 0.05;
  const auto exponent =
      fitted(pixels, [](double was, double is) { return std::log(is) / std::log(was); });
  if (!exponent || !(*exponent > 0) || std::abs(std::log(*exponent)) < least_bend) return;
  const std::string text =
      *exponent < 1 ? fmt::format("1/{:.3g}", 1 / *exponent) : fmt::format("{:.3g}", *exponent);
  add_explanation(found, Fault::colors, "values are raised to a power of " + text,
                  left_by_curve(pixels, pixels.nearly_all(),
                                [&](double x) { return std::pow(std::max(x, 0.0), *exponent); }));
}

void add_factor(const WrongPixels& pixels, Explanations& found) {
  constexpr double least_change = 0.01;
  const auto factor = fitted(pixels, [](double was, double is) { return is / was; });
  if (!factor || std::abs(*factor - 1) < least_change) return;
  const double larger = std::max(*factor, 1.0);
  const auto left =
      left_by_curve(pixels, larger * pixels.nearly_all(), [&](double x) { return *factor * x; });
  if (!left) return;
  const bool are_bytes = std::abs(*factor - 255) < 0.5;
  found.push_back({Fault::colors,
                   are_bytes ? "values of 0 to 255 in the place of 0 to 1"
                             : fmt::format("values are multiplied by {:.4g}", *factor),
                   *left / larger});
}

}  // namespace

void of_other_colors(const WrongPixels& pixels, Explanations& found) {
  const double most = pixels.nearly_all();
  add_explanation(found, Fault::colors, "encoded as sRGB",
                  left_by_curve(pixels, most, encoded_as_srgb<double>));
  add_explanation(found, Fault::colors, "decoded from sRGB",
                  left_by_curve(pixels, most, decoded_from_srgb<double>));
  const struct {
    WrongPixels::Composite composite;
    const char* what;
  } ways[] = {{straight, "straight alpha: neither multiplied by A nor over the background"},
              {multiplied_again, "colours are multiplied by their opacity twice"},
              {blended_again, "the picture is blended over its background twice"},
              {not_multiplied, "colours are blended without their opacity"}};
  for (const auto& [composite, what] : ways)
    add_explanation(found, Fault::colors, what, pixels.left_by_composite(composite, most));
  add_exchanged(pixels, found);
}

void of_brighter_colors(const WrongPixels& pixels, Explanations& found) {
  add_power(pixels, found);
  add_factor(pixels, found);
}

}  // namespace pellucid::compare
