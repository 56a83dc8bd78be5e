// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/pictures/faults/given_faults.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "compare/pictures/faults/color_faults.h"
#include "compare/pictures/faults/picture_shift.h"
#include "compare/pictures/metrics.h"

namespace pellucid::compare {
namespace {

/// Rounding to 8 bits is an error of 1 / (255 √12) = 1.1e-3: below this nothing can be told.
constexpr double least_error = 1.5e-3;
/// What undoing a fault in floats may leave.
constexpr double float_rounding = 1e-5;
/// A fault is named when undoing it leaves no more of the error than this.
constexpr double left_of_error = 1.0 / 3;
/// What leaves no less than this of what another leaves explains no more.
constexpr double clearly = 0.9;

/// A Turn of the rows, of the columns, or of both.
struct Turn {
  const char* name;
  bool rows, columns;
};

constexpr Turn turns[] = {{"", false, false},
                          {"looks upside down (row 0 is the top)", true, false},
                          {"looks mirrored, left for right", false, true},
                          {"looks turned by 180 degrees", true, true}};

Image turned(const Image& image, const Turn& turn) {
  Image result = image;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      result.at(x, y) =
          image.at(turn.columns ? image.width - 1 - x : x, turn.rows ? image.height - 1 - y : y);
  return result;
}

/// What of turns and colours explains most of the error, and what the picture is without it.
struct Explanation {
  const Turn* turn = turns;
  const ColorFault* color = &color_faults().front();
  Image upright, image;  // without the turn; without both
};

/// Each part has to earn its place. Of colours that explain as much the first is named: where all
/// is opaque what is seen beside it is a background, and nothing tells that colours are straight.
Explanation best_explanation(const Image& test, const Truth& truth) {
  Explanation best{turns, &color_faults().front(), test, test};
  double least = rmse(truth.reference, test) / clearly;
  if (least < least_error) return best;
  for (const Turn& turn : turns) {
    const Image upright = turned(test, turn);
    for (const ColorFault& color : color_faults()) {
      const int parts = (&turn != turns) + (&color != &color_faults().front());
      if (parts == 0) continue;
      Image image = color.undone(upright, truth);
      const double left = std::max(float_rounding, rmse(truth.reference, image));
      const double weighted = left / std::pow(left_of_error, parts);
      if (!(weighted < clearly * least)) continue;
      least = weighted;
      best = {&turn, &color, upright, std::move(image)};
    }
  }
  return best;
}

std::string shift_text(double by, const char* positive, const char* negative) {
  return fmt::format("{:.2f} pixels {}", std::abs(by), by > 0 ? positive : negative);
}

std::optional<std::string> shift_fault(const Image& reference, const Image& test,
                                       const Vec3& background) {
  constexpr double least = 0.25, deviations = 3;
  const std::optional<Shift> shift = picture_shift(reference, test, background);
  const auto matters = [&](double by) {
    return std::abs(by) > least + deviations * shift->uncertainty;
  };
  if (!shift || (!matters(shift->x) && !matters(shift->y))) return std::nullopt;
  std::string text = "looks shifted by";
  if (matters(shift->x)) text += ' ' + shift_text(shift->x, "to the right", "to the left");
  if (matters(shift->x) && matters(shift->y)) text += " and";
  if (matters(shift->y)) text += ' ' + shift_text(shift->y, "down", "up");
  return text + ": a pixel is sampled at its centre";
}

/// What looks wrong, and the RMSE that is left when it is undone.
struct FoundFaults {
  std::vector<std::string> texts;
  double left = 0;
};

FoundFaults found_faults(const Image& reference, const Image& test, const Vec3& background) {
  const Explanation found = best_explanation(test, {reference, background});
  FoundFaults faults{{}, rmse(reference, found.image)};
  for (const char* name : {found.turn->name, found.color->name})
    if (*name) faults.texts.emplace_back(name);
  const Image& shown = is_background(*found.color) ? found.upright : found.image;
  const std::optional<Vec3> behind = is_background(*found.color)
                                         ? color_behind({reference, background}, shown)
                                         : color_of_uncovered(reference, shown);
  const bool is_other =
      behind && largest(glm::abs(*behind - background)) > found.color->background_apart;
  if (is_other)
    faults.texts.push_back(fmt::format(
        "has another background: ({:.3g}, {:.3g}, {:.3g}); the scene's is ({:.3g}, {:.3g}, {:.3g})",
        behind->r, behind->g, behind->b, background.r, background.g, background.b));
  if (!is_other || is_background(*found.color))
    if (auto shift = shift_fault(reference, found.image, background))
      faults.texts.push_back(*shift);
  return faults;
}

/// Where the two explain as much as one's own faults do, or more.
std::optional<std::string> straight_colors(const Image& reference, const Image& test,
                                           double left_by_faults) {
  const Vec3 nothing(0);
  const double apart = rmse(reference, test);
  if (apart < least_error || max_alpha_error(reference, test) > same_color) return std::nullopt;
  const auto text = [](const char* straight, const char* multiplied, double left) {
    return fmt::format(
        "{} looks to have straight colours, as a .png without a background has, and {} such that "
        "are multiplied by A: multiplied, too, it is {:.3g} (RMSE) away",
        straight, multiplied, left);
  };
  const double of_test = rmse(reference, multiplied_over_background(test, {reference, nothing}));
  const double of_reference = rmse(multiplied_over_background(reference, {test, nothing}), test);
  const double least = std::max(float_rounding, std::min(of_test, of_reference));
  if (least >= left_of_error * apart || clearly * least > std::max(float_rounding, left_by_faults))
    return std::nullopt;
  return of_test <= of_reference ? text("TEST", "REFERENCE", of_test)
                                 : text("REFERENCE", "TEST", of_reference);
}

/// The middle colour of what a picture leaves uncovered; black where it covers everything.
Vec3 background_of(const Image& image) {
  return color_of_uncovered(image, image).value_or(Vec3(0));
}

}  // namespace

std::vector<std::string> given_faults(const Image& reference, const Image& test,
                                      const Vec3& background) {
  return found_faults(reference, test, background).texts;
}

PairFaults pair_faults(const Image& reference, const Image& test, bool have_alpha) {
  FoundFaults of_test = found_faults(reference, test, background_of(reference));
  FoundFaults of_reference = found_faults(test, reference, background_of(test));
  PairFaults faults;
  if (have_alpha)
    faults.straight = straight_colors(reference, test, std::min(of_test.left, of_reference.left));
  if (faults.straight) return faults;
  const double apart = rmse(reference, test);
  const auto explains = [&](const FoundFaults& found) {
    return found.left < left_of_error * apart;
  };
  const auto explains_all = [](const FoundFaults& found) { return found.left < least_error; };
  const bool is_of_reference = (!explains(of_test) && explains(of_reference)) ||
                               (!explains_all(of_test) && explains_all(of_reference));
  (is_of_reference ? faults.of_reference : faults.of_test) =
      std::move(is_of_reference ? of_reference : of_test).texts;
  return faults;
}

}  // namespace pellucid::compare
