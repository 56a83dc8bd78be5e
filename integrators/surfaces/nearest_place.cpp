// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/surfaces/nearest_place.h"

#include <cmath>

namespace pellucid::integrators {

Stretch stretch_around(std::span<const double> corners, bool closed, double s) {
  const double turn = closed ? std::floor(s) : 0;
  const auto above = std::ranges::upper_bound(corners, s - turn);
  const bool first = above == corners.begin(), last = above == corners.end();
  if (!closed) return {first ? 0 : *std::prev(above), last ? 1 : *above};
  if (corners.empty()) return {};
  return {turn + (first ? corners.back() - 1 : *std::prev(above)),
          turn + (last ? corners.front() + 1 : *above)};
}

Move move_within(const Tangents& tangents, const Place& from, const Stretch& s, const Stretch& t,
                 const Vec3& off) {
  const auto inside_s = [&](double ds) { return s.inside(from.s + ds) - from.s; };
  Move move = tangents.move_towards(off);
  if (inside_s(move.ds) != move.ds) move = tangents.along_t(off, inside_s(move.ds));
  const double inside_t = t.inside(from.t + move.dt);
  if (inside_t != from.t + move.dt) {
    move = tangents.along_s(off, inside_t - from.t);
    move.ds = inside_s(move.ds);
  }
  return move;
}

NearestPlace nearest_place(const SmoothPiece& piece, Place place, const Vec3& x) {
  constexpr int iterations = 24, halvings = 16;
  FlowPoint here = piece.point_at(place.s, place.t);
  for (int iteration = 0; iteration < iterations; ++iteration) {
    const Vec3 off = x - here.x;
    const double distance = glm::length(off);
    const Tangents tangents(here);
    const bool regular = tangents.span_a_plane();
    Move move = piece.move(tangents, place, off);
    // No closer than what two trajectories differ by. Near rest a long time makes a short way.
    const bool stays = std::abs(move.ds) <= piece.small.ds && std::abs(move.dt) <= piece.small.dt;
    if (tangents.way(move) <= std::max(1e-4 * distance, piece.noise) && (stays || !regular))
      return {place, here, distance, regular};
    Place next;
    FlowPoint there;
    int halving = 0;
    for (;; ++halving, move.ds *= 0.5, move.dt *= 0.5) {
      next = {place.s + move.ds, place.t + move.dt};
      there = piece.point_at(next.s, next.t);
      if (glm::distance(there.x, x) < distance) break;
      if (halving == halvings) return {place, here, distance, false};
    }
    place = next, here = there;
  }
  return {place, here, glm::distance(here.x, x), false};
}

NearestPlace nearest_of(const SmoothPiece& piece, NearestPlace nearest,
                        std::span<const Place> starts, const Vec3& x) {
  constexpr double nearer = 0.9;
  for (const Place& start : starts) {
    if (nearest.distance <= piece.noise) break;
    const NearestPlace other = nearest_place(piece, start, x);
    if (other.distance < nearer * nearest.distance) nearest = other;
  }
  return nearest;
}

}  // namespace pellucid::integrators
