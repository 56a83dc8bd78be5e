// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/view_depth.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

#include "core/error.h"
#include "geometry/vertices.h"
#include "scene/view/picture_frustum.h"
#include "scene/view/ribbon.h"

namespace pellucid::scene {
namespace {

// Of the largest coordinate of what is in the picture. A view depth is a sum of three products of
// coordinates relative to the eye: it errs by up to 5 units of 2^-53 of them, on either side, and
// vertices may lie somewhat outside of the picture.
constexpr double rounding = 0x1p-46;

/// Corners 2 i and 2 i + 1 of the strip at point i of a line; see ribbon_triangles().
std::vector<Vec3> ribbon_corners(std::span<const Vec3> line, std::span<const Vec3> half_widths) {
  std::vector<Vec3> corners;
  for (std::size_t i = 0; i < line.size(); ++i)
    for (const Vec3& corner : {line[i] - half_widths[i], line[i] + half_widths[i]})
      corners.push_back(corner);
  return corners;
}

/// Depths of shapes, one after the other.
class DepthsOfShapes {
 public:
  DepthsOfShapes(const PictureFrustum& frustum, Projection projection)
      : frustum_(frustum), projection_(projection) {}

  void operator()(const geometry::TriangleMesh& mesh) {
    add_corners(mesh.positions);
    for (const auto& triangle : mesh.triangles) add_triangle(triangle);
  }
  void operator()(const PointObject& points) {
    const bool sphere = points.profile == PointObject::Profile::sphere;
    for (std::size_t i = 0; i < points.set.positions.size(); ++i) {
      const double radius = points.radius.at(i);
      if (radius == 0) continue;  // not drawn
      const Vec3 reach(radius, radius, sphere ? radius : 0);
      const Vec3 p = frustum_.from_world(points.set.positions[i]);
      add_box({p - reach, p + reach});
    }
  }
  void operator()(const Isosurface& surface) {
    Box3 box;
    for (const Vec3& x : surface.corners.positions) box.extend(frustum_.from_world(x));
    add_box(box);
  }
  void operator()(const LineObject& lines) {
    const std::span<const Vec3> points(lines.set.positions);
    for (std::size_t k = 0; k < lines.set.line_count(); ++k) {
      const std::size_t first = lines.set.offsets[k], count = lines.set.offsets[k + 1] - first;
      const auto line = points.subspan(first, count);
      const RadiusSpan radius = lines.radius.of(first, count);
      lines.profile == LineObject::Profile::tube ? add_tube(line, radius)
                                                 : add_ribbon(line, radius);
    }
  }

  const DepthInterval& in_picture() const { return in_picture_; }
  const DepthInterval& everywhere() const { return everywhere_; }

 private:
  /// Makes the corners of the triangles that follow.
  void add_corners(std::span<const Vec3> positions) {
    corners_.clear();
    outcodes_.clear();
    for (const Vec3& x : positions) {
      corners_.push_back(frustum_.from_world(x));
      outcodes_.push_back(frustum_.outcode(corners_.back()));
    }
  }

  void add_triangle(const std::array<std::uint32_t, 3>& triangle) {
    const auto [a, b, c] = triangle;
    const std::array<Vec3, 3> corners{corners_[a], corners_[b], corners_[c]};
    for (const Vec3& p : corners) everywhere_.extend({p.z, p.z});
    if (outcodes_[a] & outcodes_[b] & outcodes_[c]) return;
    if (outcodes_[a] | outcodes_[b] | outcodes_[c])
      return in_picture_.extend(frustum_.depths(corners));
    for (const Vec3& p : corners) in_picture_.extend({p.z, p.z});
  }

  void add_ribbon(std::span<const Vec3> line, RadiusSpan radius) {
    ribbon_half_widths(line, radius, frustum_.frame(), projection_, half_widths_);
    add_corners(ribbon_corners(line, half_widths_));
    for (std::uint32_t i = 0; i + 1 < line.size(); ++i)
      for (const auto& triangle : ribbon_triangles(i)) add_triangle(triangle);
  }

  void add_tube(std::span<const Vec3> line, RadiusSpan radius) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      Box3 box;
      for (const std::size_t end : {i, i + 1}) {
        const Vec3 p = frustum_.from_world(line[end]);
        box.extend(p - radius.at(end));
        box.extend(p + radius.at(end));
      }
      add_box(box);
    }
  }

  void add_box(const Box3& box) {
    everywhere_.extend({box.min.z, box.max.z});
    in_picture_.extend(frustum_.depths(box));
  }

  const PictureFrustum& frustum_;
  Projection projection_;
  DepthInterval in_picture_, everywhere_;
  std::vector<Vec3> corners_, half_widths_;
  std::vector<unsigned> outcodes_;
};

bool fits(const Vec3& x) {
  return glm::all(glm::lessThan(glm::abs(x), Vec3(geometry::coordinate_limit)));
}

void check_size(const SceneObject& object) {
  if (const Box3 box = object.bounds(); !box.empty() && !(fits(box.min) && fits(box.max)))
    throw InputError(fmt::format(
        "{}: its coordinates, or a radius, reach 1e300 or beyond; accepted: less", object.name));
}

/// The object's name, and what it was made from where that is known by its name.
std::string origin_of(const SceneObject& object, const Scene& scene) {
  const auto how = scene.provenance.find(object.name);
  return how == scene.provenance.end() ? object.name
                                       : fmt::format("{} ({})", object.name, how->second);
}

/// Where the objects come from, so that a file whose points lie elsewhere is named.
std::string names_of_objects(const Scene& scene) {
  constexpr std::size_t most = 3;
  std::string names;
  for (std::size_t i = 0; i < std::min(scene.objects.size(), most); ++i)
    names += (i > 0 ? ", " : "") + origin_of(scene.objects[i], scene);
  if (scene.objects.size() > most)
    names += fmt::format(" and {} more", scene.objects.size() - most);
  return names;
}

DepthRange widened(const DepthInterval& bounds, double noise) {
  const double length = bounds.max - bounds.min;
  // One single depth: any interval around it will do.
  const double margin = length > noise ? 1e-5 * length : 0.5 * bounds.max;
  return {std::max(bounds.min - margin, 0.5 * bounds.min), bounds.max + margin};
}

}  // namespace

struct DepthBounds::State {
  State(const Camera& camera, int width, int height)
      : frustum(camera, width, height), depths(frustum, camera.projection) {}

  PictureFrustum frustum;
  DepthsOfShapes depths;
};

DepthBounds::DepthBounds(const Camera& camera, int width, int height)
    : state_(std::make_unique<State>(camera, width, height)) {
  if (!fits(camera.eye)) throw InputError("camera.eye: accepted: coordinates below 1e300");
}

DepthBounds::~DepthBounds() = default;

void DepthBounds::add(const SceneObject& object) {
  check_size(object);
  std::visit(state_->depths, object.shape);
}

DepthRange DepthBounds::range(const Scene& scene) const {
  const DepthsOfShapes& depths = state_->depths;
  if (!(depths.everywhere().max > 0))
    fail_at(scene, InputError(fmt::format("camera: nothing of {} is in front of it; accepted: an "
                                          "eye and a target that see the objects",
                                          names_of_objects(scene))));
  DepthInterval bounds = depths.in_picture();
  if (!(bounds.max > 0)) bounds = depths.everywhere();
  // Geometry that reaches behind the eye is seen from the eye on.
  bounds.min = std::max(bounds.min, 0.0);
  return widened(bounds, rounding * state_->frustum.reach(bounds.max));
}

DepthRange depth_range(const Scene& scene) {
  try {
    DepthBounds bounds(scene.camera, scene.width, scene.height);
    for (const SceneObject& object : scene.objects) bounds.add(object);
    return bounds.range(scene);
  } catch (const InputError& error) {
    fail_at(scene, error);
  }
}

}  // namespace pellucid::scene
