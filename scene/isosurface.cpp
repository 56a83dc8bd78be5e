// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/isosurface.h"

#include <algorithm>
#include <cmath>

#include "fields/levels/level_field.h"
#include "geometry/solid_mesh.h"
#include "scene/appearance/appearance.h"
#include "scene/appearance/colormap.h"

namespace pellucid::scene {

double Isosurface::OtherScalar::fraction(const Vec3& x) const {
  return fraction_of(field->value(x).value_or(range.x), range, scale);
}

Vec3 Isosurface::Coloring::color(double fraction) const {
  if (nan && std::isnan(fraction)) return *nan;
  return custom ? (*custom)(fraction) : (*map)(fraction);
}

float Isosurface::Fading::opacity(const Vec3& x) const {
  return float(std::lerp(opacities.x, opacities.y, std::clamp(scalar.fraction(x), 0.0, 1.0)));
}

bool Isosurface::cuts_away(const Vec3& x) const {
  if (const auto* ball = std::get_if<Ball>(&hole))
    return glm::length(x - ball->center) < ball->radius;
  const auto* body = std::get_if<Body>(&hole);
  return body && body->solid->within(x, body->distance);
}

}  // namespace pellucid::scene
