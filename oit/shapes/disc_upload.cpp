// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/shapes/disc_upload.h"

#include <fmt/format.h>

#include "core/error.h"
#include "oit/shapes/batch.h"
#include "oit/shapes/guard_band.h"

namespace pellucid::oit {
namespace {

struct Point {  // see disc.vert.glsl
  glm::vec3 center;
  float radius;
  glm::vec4 color;
};
static_assert(sizeof(Point) == 32);

/// Of a point in view units; 0 of one that is not in the picture.
float drawn_radius(const GuardBand& band, const ViewSpace& view, const scene::PointObject& points,
                   std::size_t i, const std::string& object) {
  const Vec3 center = view.exact_position(points.set.positions[i]);
  const double radius = view.exact_length(points.radius.at(i));
  if (radius == 0 || band.disc_misses_picture(center, radius)) return 0;
  if (!band.holds_disc(center, radius))
    throw InputError(
        fmt::format("{}: a disc of radius {} reaches over 10000 times farther than the picture; "
                    "accepted by this "
                    "method: less; raytrace draws it",
                    object, points.radius.at(i)));
  return float(radius);
}

}  // namespace

BufferTexture upload_discs(const Gl& gl, const scene::Scene& scene, const ViewSpace& view) {
  std::uint64_t n = 0;
  for (const scene::SceneObject& object : scene.objects)
    if (kind_of(object) == ShapeKind::disc) n += primitive_count(object);
  const GuardBand band(view);
  const auto append = [&](const scene::PointObject& points, const std::string& name, Point* out) {
    for (std::size_t i = 0; i < points.set.positions.size(); ++i)
      *out++ = {view.position(points.set.positions[i]), drawn_radius(band, view, points, i, name),
                points.set.colors[i]};
    return out;
  };
  return {gl, GL_RGBA32F, Buffer::filled<Point>(gl, n, [&](Point* out) {
            for (const scene::SceneObject& object : scene.objects)
              if (kind_of(object) == ShapeKind::disc)
                out = append(std::get<scene::PointObject>(object.shape), object.name, out);
          })};
}

}  // namespace pellucid::oit
