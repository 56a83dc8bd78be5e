// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <initializer_list>

#include "compare/conform/diagnosis/diagnose.h"
#include "compare/conform/diagnosis/explanations.h"
#include "compare/conform/diagnosis/wrong_composites.h"

namespace pellucid::compare {
namespace {

/// Whether what is wrong is n/255 all over: what errs by as little may be in half floats.
bool has_8_bit_values(const WrongPixels& pixels) {
  constexpr float near = 0.01f;  // of a step
  return std::ranges::all_of(pixels.wrong(), [&](std::size_t i) {
    const glm::vec3 steps = 255.f * glm::vec3(pixels.shown(i));
    return glm::all(glm::lessThan(glm::abs(steps - glm::round(steps)), glm::vec3(near)));
  });
}

/// A Way is how a renderer may lose digits; of some it takes several layers to see.
struct Way {
  WrongPixels::Composite composite;
  const char* what;
  bool takes_several;
};

void add_ways(const WrongPixels& pixels, std::string_view fault, std::initializer_list<Way> ways,
              double most, Explanations& found) {
  const bool are_several = std::ranges::any_of(
      pixels.wrong(), [&](std::size_t i) { return pixels.layers(i).size() > 1; });
  for (const Way& way : ways)
    if (are_several || !way.takes_several)
      add_explanation(found, fault, way.what, pixels.left_by_composite(way.composite, most));
}

/// A renderer may round otherwise by half a step at each of its last steps.
void add_rounded(const WrongPixels& pixels, Halfway halfway, Explanations& found) {
  constexpr double most = 3 * half_step;
  const auto rounding = [halfway](auto way) {
    return [=](const Layers& all, const Vec3& color) { return way(all, color, halfway); };
  };
  add_ways(pixels, Fault::eight_bits,
           {{rounding(blended_in_8_bits), "every blending is rounded to 8 bits", true},
            {rounding(accumulated_in_8_bits), "colour and opacity are summed up in 8 bits", false},
            {rounding(stored_in_8_bits), "fragments are kept in 8 bits", false},
            {rounding(opacities_in_8_bits), "opacities are kept in 8 bits", false}},
           most, found);
}

}  // namespace

void of_8_bits(const WrongPixels& pixels, Explanations& found) {
  if (pixels.max_error() <= 2 * half_step && has_8_bit_values(pixels))
    found.push_back({Fault::eight_bits, "the result is rounded to 8 bits", 0});
  for (const Halfway halfway : {Halfway::nearest, Halfway::down, Halfway::up})
    add_rounded(pixels, halfway, found);
}

void of_half_floats(const WrongPixels& pixels, Explanations& found) {
  add_ways(pixels, Fault::precision,
           {{rounded_to_halves, "the result is rounded to half floats", false},
            {blended_in_halves, "every blending is rounded to half floats", true},
            {stored_in_halves, "fragments are kept in half floats", false}},
           pixels.tolerance() + 2 * half_float_step, found);
}

}  // namespace pellucid::compare
