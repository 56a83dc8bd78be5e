// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/shapes/isosurface/surface_look.h"

#include <cmath>

#include "fields/levels/level_field.h"
#include "scene/appearance/colormap.h"

namespace pellucid::oit {
namespace {

constexpr double linear = 1, logarithmic = 2, step = 3;  // SCALE_…; the last has no name there

ScaleNumbers numbers_of(const scene::Isosurface::OtherScalar& scalar) {
  // A sample stands for unit × (kept + offset).
  const fields::SampleScale& samples = scalar.field->scale();
  const double offset = samples.value(0), unit = samples.value(1) - offset;
  const double low = scalar.range.x, high = scalar.range.y;
  if (low == high) return {step, unit, offset - low, 0};
  if (scalar.scale == scene::Scale::logarithmic)
    return {logarithmic, unit / low, offset / low, std::log(high) - std::log(low)};
  // Not a difference of fractions: beside large numbers a unit is nothing.
  const double width = high - low;
  const double factor = std::isfinite(width) ? unit / width : unit / 2 / (high / 2 - low / 2);
  return {linear, factor, scene::fraction_of(offset, scalar.range), 0};
}

void append_stops(const scene::Isosurface::Coloring& coloring, std::vector<double>& stops) {
  const auto append = [&](double at, const Vec3& color) {
    stops.insert(stops.end(), {at, color.x, color.y, color.z});
  };
  if (coloring.custom) {
    const Vec2 ends = coloring.custom->ends();
    for (const scene::ColorStop& stop : coloring.custom->stops())
      append(scene::fraction_between(stop.at, ends.x, ends.y), stop.color);
    return;
  }
  const int last = coloring.map->count - 1;
  for (int i = 0; i <= last; ++i) append(double(i) / last, (*coloring.map)(double(i) / last));
}

}  // namespace

SurfaceLook look_of(const scene::Isosurface& surface, const Vec3& eye, std::size_t first,
                    std::vector<double>& stops) {
  const Rgba& plain = surface.corners.colors.front();
  SurfaceLook look;
  look.color = Vec3(plain);
  look.opacity = plain.a;
  look.first_stop = double(first);
  if (surface.coloring) {
    append_stops(*surface.coloring, stops);
    look.stop_count = double(stops.size()) / 4;
    look.color_scale = numbers_of(surface.coloring->scalar);
    look.nan_color = surface.coloring->color(std::nan(""));
  }
  if (surface.fading) {
    look.fading_scale = numbers_of(surface.fading->scalar);
    look.opacities = surface.fading->opacities;
  }
  if (const auto* ball = std::get_if<scene::Isosurface::Ball>(&surface.hole)) {
    look.hole = ball->center - eye;
    look.hole_radius = ball->radius;
  }
  return look;
}

}  // namespace pellucid::oit
