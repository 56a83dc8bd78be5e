// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/front/seed_features.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/parallel.h"
#include "integrators/paths/magnitude.h"
#include "integrators/paths/seed_place.h"

namespace pellucid::integrators {
namespace {

constexpr double largest_bend = 0.25;  // of the largest speed: steeper changes are features

/// The seed curve's velocities at s = i / seed_looks.
class Looks {
 public:
  explicit Looks(const SurfaceRequest& request) {
    const auto sampler = request.field->sampler();
    const Box3 domain = request.field->domain();
    for (int i = 0; i <= seed_looks; ++i) {
      const Vec3 x = onto_edge(domain, request.seed.point_at(double(i) / seed_looks));
      Vec3 v;
      const bool there = sampler->velocity(x, request.start_time, v) == fields::SampleStatus::ok;
      velocities_.push_back(there ? std::optional(v) : std::nullopt);
      if (there) largest_speed_ = std::max(largest_speed_, magnitude(v));
    }
  }

  bool is_there(int i) const { return velocities_[std::size_t(i)].has_value(); }

  /// The look between two whose velocity is farthest off the line between theirs, if that is far.
  std::optional<int> largest_bend_between(int a, int b) const {
    if (!is_there(a) || !is_there(b)) return std::nullopt;
    double largest = largest_bend * largest_speed_;
    std::optional<int> found;
    for (int i = a + 1; i < b; ++i) {
      if (!is_there(i)) continue;
      const Vec3 line = glm::mix(*velocities_[std::size_t(a)], *velocities_[std::size_t(b)],
                                 double(i - a) / (b - a));
      const double bend = magnitude(*velocities_[std::size_t(i)] - line);
      if (bend > largest) largest = bend, found = i;
    }
    return found;
  }

 private:
  std::vector<std::optional<Vec3>> velocities_;
  double largest_speed_ = 0;
};

/// Adds the middle of each stretch of looks where the field is there, or is not, that has none of
/// the places.
void add_stretches(const Looks& looks, std::vector<int>& places) {
  std::vector<int> middles;
  for (int begin = 0, end; begin <= seed_looks; begin = end) {
    for (end = begin + 1; end <= seed_looks && looks.is_there(end) == looks.is_there(begin);) ++end;
    const auto first = std::lower_bound(places.begin(), places.end(), begin);
    if (first == places.end() || *first >= end) middles.push_back((begin + end - 1) / 2);
  }
  places.insert(places.end(), middles.begin(), middles.end());
  std::sort(places.begin(), places.end());
}

/// How a particle's way ends.
struct Fate {
  EndReason end;
  double t, speed;  // there
};

/// By how much the border of the surface jumps between two particles, world units: in whatever
/// each of them ends by, at the faster one's speed.
double jump_between(const Fate& a, const Fate& b) {
  if (a.end != b.end) return std::numeric_limits<double>::infinity();
  if (!is_border(a.end)) return 0;
  return std::abs(a.t - b.t) * std::max(a.speed, b.speed);
}

/// Follows particles from looks, to tell between which of them their ways' ends part.
class Followed {
 public:
  Followed(const SurfaceRequest& request, const SurfaceSetup& setup)
      : request_(request), setup_(setup), source_(request, setup), fates_(followed_looks + 1) {
    parallel_for(0, followed_looks + 1, [&](int i) { fates_[std::size_t(i)] = fate(i * stride); });
  }

  std::uint64_t evaluations() const { return source_.evaluations(); }

  /// Adds the two neighbouring looks between which the surface's border jumps, wherever it does,
  /// and those between which it is straight.
  void add_edges(std::vector<int>& places) {
    int begin = 0;
    for (int i = 0; i < followed_looks; ++i) {
      const double jump = jump_between(fate_of(i), fate_of(i + 1));
      if (!(jump > setup_.shortest_edge)) continue;
      if (!add_edge({i * stride, fate_of(i)}, {(i + 1) * stride, fate_of(i + 1)}, jump, places))
        continue;
      add_bends(begin, i, places);
      begin = i + 1;
    }
    add_bends(begin, followed_looks, places);
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
  }

 private:
  static constexpr int stride = seed_looks / followed_looks;

  struct Look {
    int place;
    Fate fate;
  };

  /// A border that jumps does so whole within each of ever smaller intervals; one that leans, as
  /// where a front leaves the domain obliquely, is divided with them, and no edge: false.
  bool add_edge(Look low, Look high, double jump, std::vector<int>& places) {
    while (high.place - low.place > 1) {
      const int middle = (low.place + high.place) / 2;
      const Look look{middle, fate(middle)};
      const bool before = jump_between(low.fate, look.fate) >= jump_between(look.fate, high.fate);
      (before ? high : low) = look;
    }
    if (jump_between(low.fate, high.fate) < 0.5 * jump) return false;
    places.insert(places.end(), {low.place, high.place});
    return true;
  }

  /// Between two that end alike, where the border is farthest off the straight line, if that is
  /// far: a front whose particles stand on either side of the corner of an obstacle would reach
  /// over it.
  void add_bends(int a, int b, std::vector<int>& places) {
    double largest = setup_.shortest_edge;
    int bend = a;
    for (int i = a + 1; i < b; ++i) {
      const Fate& fate = fate_of(i);
      const double line = std::lerp(fate_of(a).t, fate_of(b).t, double(i - a) / (b - a));
      const double off = is_border(fate.end) ? std::abs(fate.t - line) * fate.speed : 0;
      if (off > largest) largest = off, bend = i;
    }
    if (bend == a) return;
    places.push_back(bend * stride);
    add_bends(a, bend, places);
    add_bends(bend, b, places);
  }

  const Fate& fate_of(int i) const { return fates_[std::size_t(i)]; }

  Fate fate(int look) {
    Trajectory path = source_.start(double(look) / seed_looks);
    if (path.exists()) path.skip_to(request_.duration, source_.sampler());
    const double speed = path.exists() ? magnitude(path.at(path.time()).v) : 0;
    return {path.end().value_or(EndReason::duration), path.time(), speed};
  }

  const SurfaceRequest& request_;
  const SurfaceSetup& setup_;
  ParticleSource source_;
  std::vector<Fate> fates_;
};

void add_bends(const Looks& looks, int a, int b, std::vector<int>& places) {
  const std::optional<int> bend = looks.largest_bend_between(a, b);
  if (!bend) return;
  places.push_back(*bend);
  add_bends(looks, a, *bend, places);
  add_bends(looks, *bend, b, places);
}

}  // namespace

SeedFeatures seed_features(const SurfaceRequest& request, const SurfaceSetup& setup,
                           std::span<const double> seeds) {
  const Looks looks(request);
  Followed followed(request, setup);
  std::vector<int> places;
  for (const double s : seeds) places.push_back(int(std::lround(s * seed_looks)));
  const std::vector<int> known = places;
  add_stretches(looks, places);
  followed.add_edges(places);
  const std::vector<int> between = places;
  for (std::size_t i = 1; i < between.size(); ++i)
    add_bends(looks, between[i - 1], between[i], places);
  SeedFeatures features{{}, followed.evaluations() + seed_looks + 1};
  for (const int place : places)
    if (!std::ranges::binary_search(known, place))
      features.seeds.push_back(double(place) / seed_looks);
  std::sort(features.seeds.begin(), features.seeds.end());
  return features;
}

}  // namespace pellucid::integrators
