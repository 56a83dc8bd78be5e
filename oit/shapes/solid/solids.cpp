// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/shapes/solid/solids.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>

#include "core/error.h"
#include "oit/gl/bindings.h"
#include "oit/shapes/solid/solid_bounds.h"
#include "oit/shapes/solid/tube_overlaps.h"

namespace pellucid::oit {
namespace {

// A solid's and a point's record: see solid_record.glsl, solid.glsl and tube.glsl.
struct Solid {
  glm::vec4 bounds;
  glm::vec2 axis;
  double radius;  // at its first point
  std::uint32_t first_point, first_overlap, overlap_count, second_radius;
};
static_assert(sizeof(Solid) == 48);

struct Point {
  Vec3 position;
  float importance, opacity;
  glm::vec4 color;
};
static_assert(sizeof(Point) == 48);

// What a segment may overlap: every fragment of it casts its ray at all of that. (llvmpipe silently
// ends the loops of a shader after 65535 iterations in all.)
constexpr std::size_t most_overlaps = 4096;
// Of a scene; two texels each, of the 2^27 that llvmpipe's textures hold.
constexpr std::size_t most_pairs = (std::size_t(1) << 26) - 1;

/// Gathers solids of a scene.
class SolidCollector {
 public:
  SolidCollector(const ViewSpace& view, bool tapered) : view_(view), tapered_(tapered) {}

  void add(const scene::PointObject& spheres) {
    for (std::size_t i = 0; i < spheres.set.positions.size(); ++i) {
      const auto point = std::uint32_t(points.size());
      add_point(spheres.set, i);
      add_solid({points[point].position, points[point].position, spheres.radius.at(i),
                 spheres.radius.at(i)},
                point);
    }
  }

  void add(const scene::LineObject& tubes, const std::string& name) {
    for (std::size_t k = 0; k < tubes.set.line_count(); ++k) {
      const auto first = std::uint32_t(solids.size());
      const std::uint64_t begin = tubes.set.offsets[k], count = tubes.set.offsets[k + 1] - begin;
      const auto point = std::uint32_t(points.size());
      const scene::RadiusSpan radius = tubes.radius.of(begin, count);
      for (std::uint64_t i = 0; i < count; ++i) add_point(tubes.set, begin + i);
      for (std::uint32_t i = 0; i + 1 < count; ++i)
        add_solid({points[point + i].position, points[point + i + 1].position, radius.at(i),
                   radius.at(i + 1)},
                  point + i);
      link(first, std::span(tubes.set.positions).subspan(begin, count), radius, name);
    }
  }

  std::vector<Solid> solids;
  std::vector<Point> points;
  std::vector<std::uint32_t> overlaps;

  /// Appends to the overlaps the radii at the second points of tubes, whose first solid is `solid`;
  /// returns the one behind their last.
  std::uint32_t append_second_radii(const scene::LineObject& tubes, std::uint32_t solid) {
    for (std::size_t k = 0; k < tubes.set.line_count(); ++k)
      for (std::uint64_t i = tubes.set.offsets[k] + 1; i < tubes.set.offsets[k + 1]; ++i) {
        solids[solid++].second_radius = std::uint32_t(overlaps.size());
        const double radius = view_.exact_length(tubes.radius.at(i));
        const auto words = std::bit_cast<std::array<std::uint32_t, 2>>(radius);
        overlaps.insert(overlaps.end(), words.begin(), words.end());
      }
    return solid;
  }

 private:
  void add_point(const geometry::Vertices& vertices, std::size_t i) {
    const float importance = vertices.importance.empty() ? 0 : vertices.importance[i];
    points.push_back(
        {view_.view_position(vertices.positions[i]), importance, 1, vertices.colors[i]});
  }

  /// The radii are in world units yet.
  void add_solid(ConeSphere solid, std::uint32_t first_point) {
    solid.radius_a = view_.exact_length(solid.radius_a);
    solid.radius_b = view_.exact_length(solid.radius_b);
    const PictureRectangle box = bounds_in_picture(solid, view_);
    solids.push_back({glm::vec4(box.first, box.second), glm::vec2(box.axis), solid.radius_a,
                      first_point, 0, 0, 0});
  }

  /// Tells the segments of a line, from solid `first` on, which of the others they overlap.
  void link(std::uint32_t first, std::span<const Vec3> line, scene::RadiusSpan radius,
            const std::string& name) {
    const std::size_t full = overlaps.size() / 2 + (tapered_ ? solids.size() : 0);
    check_overlaps(full <= most_pairs, name);
    const std::size_t most = std::min(most_pairs - full, most_overlaps / 2 * line.size());
    const std::vector<SegmentPair> pairs = overlapping_segments(line, radius, most);
    check_overlaps(pairs.size() <= most, name);
    for (const auto& [p, q] : pairs) {
      ++solids[first + p].overlap_count;
      ++solids[first + q].overlap_count;
    }
    auto next = std::uint32_t(overlaps.size());
    for (Solid& solid : std::span(solids).subspan(first)) {
      solid.first_overlap = next;
      next += solid.overlap_count;
      check_overlaps(solid.overlap_count <= most_overlaps, name);
      solid.overlap_count = 0;
    }
    overlaps.resize(next);
    const auto append = [&](std::uint32_t to, std::uint32_t other) {
      Solid& solid = solids[first + to];
      overlaps[solid.first_overlap + solid.overlap_count++] = first + other;
    };
    for (const auto& [p, q] : pairs) append(p, q), append(q, p);
  }

  static void check_overlaps(bool few, const std::string& name) {
    if (!few)
      throw InputError(fmt::format(
          "{}: too many segments of a tube overlap each other; accepted by this method: "
          "{} that one overlaps, {} pairs in all; raytrace draws it",
          name, most_overlaps, most_pairs));
  }

  const ViewSpace& view_;
  bool tapered_;  // second radii will be appended
};

template <class Call>
void for_each_tube(const scene::Scene& scene, const Call& call) {
  for (const scene::SceneObject& object : scene.objects)
    if (kind_of(object) == ShapeKind::tube) call(object);
}

bool any_tapers(const scene::Scene& scene) {
  bool any = false;
  for_each_tube(scene, [&](const scene::SceneObject& tube) { any |= tube.radii().vary(); });
  return any;
}

}  // namespace

Solids::Solids(const Gl& gl, const scene::Scene& scene, const ViewSpace& view)
    : tapered_(any_tapers(scene)) {
  SolidCollector collector(view, tapered_);
  for (const scene::SceneObject& object : scene.objects)
    if (kind_of(object) == ShapeKind::sphere)
      collector.add(std::get<scene::PointObject>(object.shape));
  spheres_ = std::uint32_t(collector.solids.size());
  for_each_tube(scene, [&](const scene::SceneObject& tubes) {
    collector.add(std::get<scene::LineObject>(tubes.shape), tubes.name);
  });
  std::uint32_t first = spheres_;
  if (tapered_)
    for_each_tube(scene, [&](const scene::SceneObject& tubes) {
      first = collector.append_second_radii(std::get<scene::LineObject>(tubes.shape), first);
    });
  collector.overlaps.push_back(0);  // a buffer texture is not empty
  solids_ = {gl, GL_RGBA32UI, Buffer(gl, collector.solids)};
  points_ = {gl, GL_RGBA32UI, Buffer::filled<Point>(gl, collector.points.size(), [&](Point* out) {
               std::ranges::copy(collector.points, out);
             })};
  overlaps_ = {gl, GL_R32UI, Buffer(gl, collector.overlaps)};
}

void Solids::set_tube_opacities(std::span<const float> opacities) const {
  if (opacities.empty()) return;
  points_.buffer().write<Point>([&](Point* points) {
    for (std::size_t i = 0; i < opacities.size(); ++i) points[spheres_ + i].opacity = opacities[i];
  });
}

Resources Solids::resources() const {
  return {solids_.as_texture(bindings::solids_texture),
          points_.as_texture(bindings::solid_points_texture),
          overlaps_.as_texture(bindings::solid_overlaps_texture)};
}

}  // namespace pellucid::oit
