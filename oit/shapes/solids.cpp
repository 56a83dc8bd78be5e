// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/shapes/solids.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "oit/gl/bindings.h"
#include "oit/shapes/capsule_bounds.h"
#include "oit/shapes/tube_overlaps.h"

namespace pellucid::oit {
namespace {

// A solid's and a point's record: see solid_record.glsl and solid.glsl.
struct Solid {
  glm::vec4 bounds;
  glm::vec2 axis;
  double radius;
  std::uint32_t first_point, first_overlap, overlap_count, unused;
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
  explicit SolidCollector(const ViewSpace& view) : view_(view) {}

  void add(const scene::PointObject& spheres) {
    for (std::size_t i = 0; i < spheres.set.positions.size(); ++i) {
      const auto point = std::uint32_t(points.size());
      add_point(spheres.set, i);
      add_solid({points[point].position, points[point].position, spheres.radius}, point);
    }
  }

  void add(const scene::LineObject& tubes, const std::string& name) {
    for (std::size_t k = 0; k < tubes.set.line_count(); ++k) {
      const auto first = std::uint32_t(solids.size());
      const std::uint64_t begin = tubes.set.offsets[k], end = tubes.set.offsets[k + 1];
      for (std::uint64_t i = begin; i < end; ++i) add_point(tubes.set, i);
      for (auto i = std::uint32_t(points.size() - (end - begin)); i + 1 < points.size(); ++i)
        add_solid({points[i].position, points[i + 1].position, tubes.radius}, i);
      link(first, std::span(tubes.set.positions).subspan(begin, end - begin), tubes.radius, name);
    }
  }

  std::vector<Solid> solids;
  std::vector<Point> points;
  std::vector<std::uint32_t> overlaps;

 private:
  void add_point(const geometry::Vertices& vertices, std::size_t i) {
    const float importance = vertices.importance.empty() ? 0 : vertices.importance[i];
    points.push_back(
        {view_.view_position(vertices.positions[i]), importance, 1, vertices.colors[i]});
  }

  /// The radius is in world units yet.
  void add_solid(Capsule capsule, std::uint32_t first_point) {
    capsule.radius = view_.exact_length(capsule.radius);
    const PictureRectangle box = bounds_in_picture(capsule, view_);
    solids.push_back({glm::vec4(box.first, box.second), glm::vec2(box.axis), capsule.radius,
                      first_point, 0, 0, 0});
  }

  /// Tells the segments of a line, from solid `first` on, which of the others they overlap.
  void link(std::uint32_t first, std::span<const Vec3> line, double radius,
            const std::string& name) {
    const std::size_t most =
        std::min(most_pairs - overlaps.size() / 2, most_overlaps / 2 * line.size());
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
};

}  // namespace

Solids::Solids(const Gl& gl, const scene::Scene& scene, const ViewSpace& view) {
  SolidCollector collector(view);
  for (const scene::SceneObject& object : scene.objects)
    if (kind_of(object) == ShapeKind::sphere)
      collector.add(std::get<scene::PointObject>(object.shape));
  spheres_ = std::uint32_t(collector.solids.size());
  for (const scene::SceneObject& object : scene.objects)
    if (kind_of(object) == ShapeKind::tube)
      collector.add(std::get<scene::LineObject>(object.shape), object.name);
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
