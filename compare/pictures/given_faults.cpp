// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/pictures/given_faults.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "compare/pictures/metrics.h"
#include "compare/pictures/picture_shift.h"
#include "compare/pictures/srgb.h"

namespace pellucid::compare {
namespace {

/// Rounding to 8 bits is an error of 1 / (255 √12) = 1.1e-3: below this nothing can be told.
constexpr double least_error = 1.5e-3;
/// What undoing a fault in floats may leave.
constexpr double float_rounding = 1e-5;
/// A fault is named when undoing it leaves no more of the error than this.
constexpr double left_of_error = 1.0 / 3;
/// As far as 8-bit rounding of a picture and of the background may be apart.
constexpr double same_color = 1.5 / 255;

template <class Function>
Image each_pixel(Image image, const Function& function) {
  for (Rgba& pixel : image.pixels) pixel = function(pixel);
  return image;
}

template <class Function>
Image each_channel(const Image& image, const Function& function) {
  return each_pixel(
      image, [&](const Rgba& p) { return Rgba(function(p.r), function(p.g), function(p.b), p.a); });
}

double largest(const Vec3& v) { return std::max({v.x, v.y, v.z}); }

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

/// What a picture is held against.
struct Truth {
  const Image& reference;
  Vec3 background;
};

Image over_background(const Image& image, const Truth& truth) {
  return each_pixel(image, [&](const Rgba& p) {
    return p + Rgba(truth.background, 0) * (1 - std::clamp(p.a, 0.f, 1.f));
  });
}

Image multiplied_over_background(const Image& image, const Truth& truth) {
  return each_pixel(image, [&](const Rgba& p) {
    return Rgba(Vec3(p) * double(p.a) + truth.background * double(1 - p.a), p.a);
  });
}

/// The colour that stands behind everything, by least squares of what is off by the reference's
/// 1 - A; nothing where nothing shows through, or where it would be no colour.
std::optional<Vec3> color_behind_all(const Truth& truth, const Image& test) {
  constexpr double least = 1e-3;   // of (1 - A)², in the mean
  constexpr double beyond = 0.02;  // black and white, by the error of the estimate
  Vec3 sum(0);
  double squares = 0;
  for (std::size_t i = 0; i < test.pixels.size(); ++i) {
    const Rgba& wanted = truth.reference.pixels[i];
    const double left = 1 - double(wanted.a);
    sum += left * (Vec3(test.pixels[i]) - Vec3(wanted));
    squares += left * left;
  }
  if (!(squares > least * double(test.pixels.size()))) return std::nullopt;
  const Vec3 color = truth.background + sum / squares;
  const Vec3 possible = glm::clamp(color, Vec3(0), Vec3(1));
  if (largest(glm::abs(color - possible)) > beyond) return std::nullopt;
  return possible;
}

std::optional<Vec3> color_behind(const Truth& truth, const Image& test) {
  const std::optional<Vec3> seen = color_of_uncovered(truth.reference, test);
  return seen ? seen : color_behind_all(truth, test);
}

/// By the reference's opacity where the picture has none of its own.
Image on_its_background(const Image& image, const Truth& truth) {
  Image result = image;
  const auto color = color_behind(truth, image);
  const bool has_own = std::ranges::any_of(image.pixels, [](const Rgba& p) { return p.a < 1; });
  const Image& opacity = has_own ? image : truth.reference;
  for (std::size_t i = 0; color && i < image.pixels.size(); ++i)
    result.pixels[i] += Rgba(truth.background - *color, 0) * (1 - opacity.pixels[i].a);
  return result;
}

/// A ColorFault is what may have happened to colours, and how it is undone.
struct ColorFault {
  const char* name;
  Image (*undone)(const Image& image, const Truth& truth);
  /// How far the background may be off when it is undone. A curve is often a power of 2.2, which is
  /// off sRGB's by up to 0.03.
  double background_apart = same_color;
};

constexpr double curves_apart = 0.04;

constexpr ColorFault color_faults[] = {
    {"", [](const Image& image, const Truth&) { return image; }},
    {"looks premultiplied: colour without the background", over_background},
    {"", on_its_background},  // its colour is told below
    {"looks like straight alpha: colour neither multiplied nor over the background",
     multiplied_over_background},
    {"looks sRGB-encoded once too often: linear values were taken for the scene's display values",
     [](const Image& image, const Truth&) { return each_channel(image, decoded_from_srgb<float>); },
     curves_apart},
    {"looks sRGB-decoded: linear values in the place of display values",
     [](const Image& image, const Truth&) { return each_channel(image, encoded_as_srgb<float>); },
     curves_apart},
    {"looks 255 times too bright: values of 0 to 255 in the place of 0 to 1",
     [](const Image& image, const Truth&) {
       return each_channel(image, [](float x) { return x / 255; });
     }}};

bool is_background(const ColorFault& color) { return color.undone == on_its_background; }

/// What of turns and colours explains most of the error, and what the picture is without it.
struct Explanation {
  const Turn* turn = turns;
  const ColorFault* color = color_faults;
  Image upright, image;  // without the turn; without both
};

/// Each part has to earn its place. Of colours that explain as much the first is named: where all
/// is opaque what is seen beside it is a background, and nothing tells that colours are straight.
Explanation best_explanation(const Image& test, const Truth& truth) {
  Explanation best{turns, color_faults, test, test};
  constexpr double clearly = 0.9;
  double least = rmse(truth.reference, test) / clearly;
  if (least < least_error) return best;
  for (const Turn& turn : turns) {
    const Image upright = turned(test, turn);
    for (const ColorFault& color : color_faults) {
      const int parts = (&turn != turns) + (&color != color_faults);
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

}  // namespace

std::optional<Vec3> color_of_uncovered(const Image& reference, const Image& test) {
  constexpr std::size_t least = 16;
  std::array<std::vector<float>, 3> channels;
  for (std::size_t i = 0; i < test.pixels.size(); ++i)
    for (int c = 0; c < 3 && reference.pixels[i].a == 0; ++c)
      channels[std::size_t(c)].push_back(test.pixels[i][c]);
  if (channels[0].size() < least) return std::nullopt;
  Vec3 median;
  for (int c = 0; c < 3; ++c) {
    std::vector<float>& values = channels[std::size_t(c)];
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    median[c] = *middle;
  }
  return median;
}

std::optional<std::string> straight_colors(const Image& reference, const Image& test) {
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
  if (std::min(of_test, of_reference) >= left_of_error * apart) return std::nullopt;
  return of_test <= of_reference ? text("TEST", "REFERENCE", of_test)
                                 : text("REFERENCE", "TEST", of_reference);
}

std::vector<std::string> given_faults(const Image& reference, const Image& test,
                                      const Vec3& background) {
  std::vector<std::string> faults;
  const Explanation found = best_explanation(test, {reference, background});
  for (const char* name : {found.turn->name, found.color->name})
    if (*name) faults.emplace_back(name);
  const Image& shown = is_background(*found.color) ? found.upright : found.image;
  const std::optional<Vec3> behind = is_background(*found.color)
                                         ? color_behind({reference, background}, shown)
                                         : color_of_uncovered(reference, shown);
  const bool is_other =
      behind && largest(glm::abs(*behind - background)) > found.color->background_apart;
  if (is_other)
    faults.push_back(fmt::format(
        "has another background: ({:.3g}, {:.3g}, {:.3g}); the scene's is ({:.3g}, {:.3g}, {:.3g})",
        behind->r, behind->g, behind->b, background.r, background.g, background.b));
  if (!is_other || is_background(*found.color))
    if (auto shift = shift_fault(reference, found.image, background)) faults.push_back(*shift);
  return faults;
}

}  // namespace pellucid::compare
