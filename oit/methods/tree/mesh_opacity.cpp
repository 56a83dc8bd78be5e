// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/methods/tree/mesh_opacity.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace pellucid::oit {
namespace {

constexpr double most_cells = 1024;  // on a side

double cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

double squared(const Vec2& a) { return glm::dot(a, a); }

/// How far along the edge from a to b, in [0, 1], the nearest point to p lies.
double along(const Vec2& a, const Vec2& b, const Vec2& p) {
  const double length2 = squared(b - a);
  return length2 > 0 ? std::clamp(glm::dot(p - a, b - a) / length2, 0.0, 1.0) : 0;
}

}  // namespace

MeshOpacity::MeshOpacity(const geometry::TriangleMesh& mesh, bool closed) {
  const auto &s = mesh.scalars.at("s"), &t = mesh.scalars.at("t");
  for (const auto& corners : mesh.triangles) {
    Facet facet;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k) {
      // Over the seam of a closed curve s jumps from 1 to 0; t < 0 on the way back.
      const double turn = closed ? std::round(s[corners[0]] - s[corners[k]]) : 0;
      facet.corners[k] = {s[corners[k]] + turn, std::abs(t[corners[k]])};
      facet.opacities[k] = mesh.colors[corners[k]].a;
      least = std::min(least, facet.corners[k].x);
    }
    if (closed)
      for (Vec2& corner : facet.corners) corner.x -= std::floor(least);
    add(facet);
  }
  make_grid();
  fill_grid();
}

/// What reaches over the seam is on both of its sides.
void MeshOpacity::add(const Facet& facet) {
  facets_.push_back(facet);
  const auto is_beyond = [](const Vec2& corner) { return corner.x > 1; };
  if (std::ranges::none_of(facet.corners, is_beyond)) return;
  facets_.push_back(facet);
  for (Vec2& corner : facets_.back().corners) corner.x -= 1;
}

void MeshOpacity::make_grid() {
  Vec2 sizes(0), end(0);
  for (const Facet& facet : facets_) {
    const auto& [a, b, c] = facet.corners;
    sizes += glm::max(a, glm::max(b, c)) - glm::min(a, glm::min(b, c));
    end = glm::max(end, glm::max(a, glm::max(b, c)));
  }
  const auto cells = [&](int axis) {
    if (!(sizes[axis] > 0)) return 1;
    const double of_mean = end[axis] * double(facets_.size()) / sizes[axis];
    return int(std::clamp(std::round(of_mean), 1.0, most_cells));
  };
  columns_ = cells(0);
  rows_ = cells(1);
  cells_per_unit_ = {end.x > 0 ? columns_ / end.x : 1, end.y > 0 ? rows_ / end.y : 1};
}

void MeshOpacity::fill_grid() {
  for (std::uint32_t i = 0; i < facets_.size(); ++i) {
    const auto& [a, b, c] = facets_[i].corners;
    const Vec2 low = glm::min(a, glm::min(b, c)), high = glm::max(a, glm::max(b, c));
    for (int y = row(low.y); y <= row(high.y); ++y)
      for (int x = column(low.x); x <= column(high.x); ++x)
        entries_.emplace_back(std::uint32_t(y * columns_ + x), i);
  }
  std::ranges::sort(entries_);
}

int MeshOpacity::column(double s) const {
  return int(std::clamp(std::floor(s * cells_per_unit_.x), 0.0, double(columns_ - 1)));
}
int MeshOpacity::row(double t) const {
  return int(std::clamp(std::floor(t * cells_per_unit_.y), 0.0, double(rows_ - 1)));
}

/// At the place, or at the nearest one on the triangle's rim.
MeshOpacity::Found MeshOpacity::at_facet(const Facet& facet, const Vec2& place) const {
  const auto& [a, b, c] = facet.corners;
  const double area = cross(b - a, c - a);
  const Vec3 weights(cross(c - b, place - b), cross(a - c, place - c), cross(b - a, place - a));
  const auto& opacities = facet.opacities;
  if (area != 0 && weights.x / area >= 0 && weights.y / area >= 0 && weights.z / area >= 0)
    return {0,
            float((weights.x * opacities[0] + weights.y * opacities[1] + weights.z * opacities[2]) /
                  area)};
  Found nearest{std::numeric_limits<double>::infinity(), 0};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const Vec2 from = facet.corners[k] * cells_per_unit_,
               to = facet.corners[next] * cells_per_unit_;
    const Vec2 at = place * cells_per_unit_;
    const double part = along(from, to, at);
    const double distance = squared(from + part * (to - from) - at);
    if (distance < nearest.distance)
      nearest = {distance, std::lerp(opacities[k], opacities[next], float(part))};
  }
  return nearest;
}

void MeshOpacity::look_into(int column, int row, const Vec2& place, Found& best) const {
  if (column < 0 || row < 0 || column >= columns_ || row >= rows_) return;
  const auto cell = std::uint32_t(row * columns_ + column);
  for (const auto& [of_cell, facet] :
       std::ranges::equal_range(entries_, cell, {}, &CellEntry::first))
    if (const Found found = at_facet(facets_[facet], place); found.distance < best.distance)
      best = found;
}

/// Ring after ring of cells around the place's own: one that is n cells off holds nothing that is
/// nearer than n - 1.
float MeshOpacity::at(double s, double t) const {
  const Vec2 place(s, std::abs(t));
  const int x = column(place.x), y = row(place.y);
  Found best{std::numeric_limits<double>::infinity(), 1};
  for (int ring = 0; ring <= std::max(columns_, rows_); ++ring) {
    if (ring > 0 && best.distance <= double(ring - 1) * (ring - 1)) break;
    for (int dy = -ring; dy <= ring; ++dy) {
      const int stride = std::abs(dy) == ring ? 1 : std::max(2 * ring, 1);
      for (int dx = -ring; dx <= ring; dx += stride) look_into(x + dx, y + dy, place, best);
    }
  }
  return best.opacity;
}

std::uint64_t MeshOpacity::bytes() const {
  return facets_.capacity() * sizeof(Facet) + entries_.capacity() * sizeof(CellEntry);
}

}  // namespace pellucid::oit
