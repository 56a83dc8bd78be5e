// SPDX-License-Identifier: GPL-3.0-or-later
// Thin lines, seen as strips that face the eye, and points, seen as discs.
#include <fmt/format.h>

#include <cmath>

#include "compare/conform/case_builder.h"

namespace pellucid::compare {
namespace {

/// A Strip is a line along x or y, seen in parallel: a rectangle.
struct Strip {
  bool along_x;
  double at;        // of the other axis
  double from, to;  // along it
  double z;
  Rgba color;

  bool covers(const Vec2& p, double radius) const {
    const double along = along_x ? p.x : p.y, across = along_x ? p.y : p.x;
    return std::abs(across - at) < radius && along > from && along < to;
  }
  Vec3 end(double s) const { return along_x ? Vec3(s, at, z) : Vec3(at, s, z); }
};

/// Things that cover a point of the picture, the nearest first.
template <class Thing>
Layers layers_of(std::vector<Thing> things, const Vec2& p, double radius) {
  std::ranges::sort(things, std::greater(), &Thing::z);
  Layers layers;
  for (const Thing& thing : things)
    if (thing.covers(p, radius)) layers.push_back(thing.color);
  return layers;
}

void add_lines(std::vector<ConformanceCase>& cases, double n, const char* name, const char* what,
               double radius, const std::vector<Strip>& strips) {
  ConformanceCase c{.name = fmt::format("lines-{}", name),
                    .family = "lines",
                    .n = n,
                    .what = what,
                    .scene = parallel_scene(),
                    .layers = {},
                    .which = {}};
  scene::LineObject lines;
  lines.radius = radius;
  for (const Strip& strip : strips) {
    for (const double end : {strip.from, strip.to}) {
      lines.set.positions.push_back(strip.end(end));
      lines.set.colors.push_back(strip.color);
    }
    lines.set.offsets.push_back(lines.set.positions.size());
  }
  c.scene.objects.push_back({"lines", std::move(lines)});
  set_layers(c, [&](int x, int y) { return layers_of(strips, center_of(x, y), radius); });
  cases.push_back(std::move(c));
}

void add_line_cases(std::vector<ConformanceCase>& cases) {
  const Rgba red(0.9, 0.1, 0.2, 0.6), green(0.1, 0.8, 0.2, 0.5), blue(0.2, 0.2, 0.9, 0.7);
  add_lines(cases, 1, "wide", "a line three pixels wide that ends in the picture", 1.5,
            {{true, 2.25, -20, 3, 0, red}});
  add_lines(cases, 2, "thin", "lines of a quarter of a pixel, through pixel centres", 0.125,
            {{true, 2.5625, -20, 20, 0, red}, {true, -4.4375, -3, 6, 0, green}});
  add_lines(cases, 3, "crossed", "thin lines over one another", 0.125,
            {{true, 2.5625, -20, 20, 0, red},
             {false, -1.4375, -20, 20, 1, green},
             {true, 2.5, -20, 20, 2, blue},
             {false, 5.5, -20, 4, -1, blue}});
}

/// A Disc is a point, seen in parallel.
struct Disc {
  Vec2 center;
  double z;
  Rgba color;

  bool covers(const Vec2& p, double radius) const { return glm::length(p - center) < radius; }
};

void add_points(std::vector<ConformanceCase>& cases, double n, const char* name, const char* what,
                double radius, const std::vector<Disc>& discs) {
  ConformanceCase c{.name = fmt::format("points-{}", name),
                    .family = "points",
                    .n = n,
                    .what = what,
                    .scene = parallel_scene(),
                    .layers = {},
                    .which = {}};
  scene::PointObject points;
  points.radius = radius;
  for (const Disc& disc : discs) {
    points.set.positions.emplace_back(disc.center, disc.z);
    points.set.colors.push_back(disc.color);
  }
  c.scene.objects.push_back({"points", std::move(points)});
  set_layers(c, [&](int x, int y) { return layers_of(discs, center_of(x, y), radius); });
  cases.push_back(std::move(c));
}

void add_point_cases(std::vector<ConformanceCase>& cases) {
  add_points(cases, 1, "large", "a disc of five pixels, two others over it", 2.625,
             {{{-1.4375, 0.5625}, 0, {0.9, 0.1, 0.2, 0.6}},
              {{0.5625, 1.4375}, 1, {0.1, 0.8, 0.2, 0.5}},
              {{4.5, -4.5}, 2, {0.2, 0.2, 0.9, 0.7}}});
  std::vector<Disc> small;
  for (std::uint64_t i = 0; i < 40; ++i) {
    const double x = std::floor(16 * random_of(100 + i)) - 8 + 0.5625;
    const double y = std::floor(16 * random_of(200 + i)) - 8 + 0.4375;
    small.push_back({{x, y}, -double(i) / 8, color_of(i, 0.5)});
  }
  add_points(cases, 2, "small", "40 discs that are smaller than a pixel, some over others", 0.25,
             small);
}

}  // namespace

void add_shape_cases(std::vector<ConformanceCase>& cases) {
  add_line_cases(cases);
  add_point_cases(cases);
}

}  // namespace pellucid::compare
