// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "compare/conform/diagnosis/diagnose.h"
#include "compare/conform/diagnosis/explanations.h"
#include "compare/pictures/faults/given_faults.h"

namespace pellucid::compare {
namespace {

void add_over(const WrongPixels& pixels, const Vec3& color, Explanations& found) {
  const Vec3& right = pixels.behind();
  add_explanation(
      found, Fault::background,
      fmt::format("({:.3g}, {:.3g}, {:.3g}) shows through, not ({:.3g}, {:.3g}, {:.3g})", color.r,
                  color.g, color.b, right.r, right.g, right.b),
      pixels.left_by_composite(
          [&](const Layers& all, const Vec3&) { return composite_of(all, color); },
          2 * pixels.nearly_all()));
}

/// A Backdrop is the colour that the pixel through which most of the background shows would have
/// behind its layers.
struct Backdrop {
  Vec3 color;
  Vec3 possible;      // within [0, 1]
  double uncertain;   // of each channel
  bool is_confirmed;  // other pixels, through which less shows, can bear it out
};

/// What lets less through tells nothing of a colour.
constexpr double enough = 0.02;

/// Nothing where too little shows through, or what does is no colour or the scene's own.
std::optional<Backdrop> backdrop_of(const WrongPixels& pixels) {
  const auto left = [&](std::size_t i) {
    return 1 - composite_of(pixels.layers(i), pixels.behind()).a;
  };
  const std::size_t clearest = *std::ranges::max_element(pixels.wrong(), {}, left);
  const double most = left(clearest);
  if (most < enough) return std::nullopt;
  const Vec3 own(composite_of(pixels.layers(clearest), Vec3(0)));
  const Vec3 color = (Vec3(pixels.shown(clearest)) - own) / most;
  const Vec3 possible = glm::clamp(color, Vec3(0), Vec3(1));
  const double uncertain = 2 * pixels.nearly_all() / most;
  const auto is_near = [&](const Vec3& a, const Vec3& b) {
    return glm::all(glm::lessThanEqual(glm::abs(a - b), Vec3(uncertain)));
  };
  if (!is_near(color, possible) || is_near(color, pixels.behind())) return std::nullopt;
  const bool is_confirmed = most > 0.999 || std::ranges::any_of(pixels.wrong(), [&](std::size_t i) {
                              return left(i) < most - enough;
                            });
  return Backdrop{color, possible, uncertain, is_confirmed};
}

/// Three channels of a grey bear one another out.
std::optional<Vec3> grey_of(const Backdrop& backdrop) {
  const Vec3& c = backdrop.possible;
  const Vec3 mean((c.r + c.g + c.b) / 3);
  const Vec3 off = glm::abs(c - mean);
  if (std::max({off.r, off.g, off.b}) > backdrop.uncertain) return std::nullopt;
  return mean;
}

/// A Motion of a picture: turned, exchanged or shifted.
struct Motion {
  const char* name;
  int xx, xy, yx, yy;  // of the source, by the pixel, both seen from the picture's middle
  int dx, dy;          // in pixels
};

constexpr Motion turns[] = {{"upside down (row 0 is the top)", 1, 0, 0, -1, 0, 0},
                            {"mirrored, left for right", -1, 0, 0, 1, 0, 0},
                            {"turned by 180 degrees", -1, 0, 0, -1, 0, 0},
                            {"rows for columns", 0, 1, 1, 0, 0, 0},
                            {"turned by 90 degrees, with the clock", 0, 1, -1, 0, 0, 0},
                            {"turned by 90 degrees, against the clock", 0, -1, 1, 0, 0, 0}};

/// What comes from beyond the rim is not known.
std::optional<double> left_by_motion(const WrongPixels& pixels, const Image& right,
                                     const Motion& m) {
  const int side = right.width;
  const auto left_of = [&](std::size_t i) {
    const int x = 2 * (int(i) % side - m.dx) - side + 1, y = 2 * (int(i) / side - m.dy) - side + 1;
    const int from_x = (m.xx * x + m.xy * y + side - 1) / 2;
    const int from_y = (m.yx * x + m.yy * y + side - 1) / 2;
    if (std::min(from_x, from_y) < 0 || std::max(from_x, from_y) >= side) return 0.0;
    return pixels.off(i, Vec3(right.at(from_x, from_y)));
  };
  return pixels.left_by_all(left_of, pixels.nearly_all());
}

}  // namespace

/// Mostly it is black or white.
void over_black_or_white(const WrongPixels& pixels, Explanations& found) {
  for (const Vec3& color : {Vec3(0), Vec3(1)}) add_over(pixels, color, found);
}

void over_another_background(const WrongPixels& pixels, Explanations& found) {
  const std::optional<Backdrop> backdrop = backdrop_of(pixels);
  if (!backdrop) return;
  if (const auto grey = grey_of(*backdrop))
    add_over(pixels, *grey, found);
  else if (backdrop->is_confirmed)
    add_over(pixels, backdrop->possible, found);
}

void over_an_unconfirmed_background(const WrongPixels& pixels, Explanations& found) {
  const std::optional<Backdrop> backdrop = backdrop_of(pixels);
  if (backdrop && pixels.max_error() > least_seen) add_over(pixels, backdrop->possible, found);
}

/// In a picture of one colour anything might be seen.
void of_a_turned_picture(const WrongPixels& pixels, Explanations& found) {
  constexpr int steps[] = {0, 1, -1, 2, -2};  // the nearest first
  const ConformanceCase& c = pixels.conformance_case();
  if (c.layers.size() < 2) return;
  const Image right = expected_picture(c);
  for (const Motion& turn : turns)
    add_explanation(found, Fault::picture, turn.name, left_by_motion(pixels, right, turn));
  for (const int x : steps)
    for (const int y : steps)
      if (x != 0 || y != 0)
        add_explanation(found, Fault::picture,
                        fmt::format("shifted by {} pixels to the right and {} down", x, y),
                        left_by_motion(pixels, right, {"", 1, 0, 0, 1, x, y}));
}

void of_the_picture(const WrongPixels& pixels, Explanations& found) {
  const ConformanceCase& c = pixels.conformance_case();
  if (c.layers.size() < 2) return;
  const auto faults = given_faults(expected_picture(c), pixels.picture(), pixels.behind());
  if (faults.empty()) return;
  found.push_back({Fault::picture, fmt::format("{}", fmt::join(faults, "; ")), 0});
}

}  // namespace pellucid::compare
