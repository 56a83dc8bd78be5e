// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/front/seed_features.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

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
      : request_(request), setup_(setup), source_(request, setup_), fates_(followed_looks + 1) {
    setup_.trajectory.max_steps = std::min(setup.trajectory.max_steps, most_steps);
    parallel_for(0, followed_looks + 1, [&](int i) { fates_[std::size_t(i)] = fate(i * stride); });
  }

  std::uint64_t evaluations() const { return source_.evaluations(); }

  /// Adds the two neighbouring looks between which the surface's border jumps, wherever it does,
  /// and those between which it is straight.
  void add_edges(std::vector<int>& places) {
    std::vector<Look> alike{look_of(0)};
    for (int i = 0; i < followed_looks; ++i) {
      if (const auto edge = edge_between(look_of(i), look_of(i + 1))) {
        places.insert(places.end(), {edge->first.place, edge->second.place});
        append(alike, edge->first);
        add_bends(alike, places);
        alike = {edge->second};
      }
      append(alike, look_of(i + 1));
    }
    add_bends(alike, places);
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
  }

 private:
  static constexpr int stride = seed_looks / followed_looks;
  // A duration of a million turns is not to take longer to look at than to sweep.
  static constexpr std::uint64_t most_steps = 20'000;

  struct Look {
    int place;
    Fate fate;
  };

  Look look_of(int i) const { return {i * stride, fates_[std::size_t(i)]}; }

  static void append(std::vector<Look>& looks, const Look& look) {
    if (look.place > looks.back().place) looks.push_back(look);
  }

  /// The two neighbouring looks where the border jumps. One that jumps does so whole within each of
  /// ever smaller intervals; one that leans, as where a front leaves the domain obliquely, is
  /// divided with them, and has no edge.
  std::optional<std::pair<Look, Look>> edge_between(Look low, Look high) {
    const double jump = jump_between(low.fate, high.fate);
    if (!(jump > setup_.shortest_edge)) return std::nullopt;
    while (high.place - low.place > 1) {
      const int middle = (low.place + high.place) / 2;
      const Look look{middle, fate(middle)};
      const bool before = jump_between(low.fate, look.fate) >= jump_between(look.fate, high.fate);
      (before ? high : low) = look;
    }
    if (jump_between(low.fate, high.fate) < 0.5 * jump) return std::nullopt;
    return std::pair(low, high);
  }

  /// Of looks that end alike, where the border is farthest off the straight line between the first
  /// and the last, if that is far: a front whose particles stand on either side of the corner of an
  /// obstacle would reach over it.
  void add_bends(std::span<const Look> looks, std::vector<int>& places) const {
    const Look &first = looks.front(), &last = looks.back();
    double largest = setup_.shortest_edge;
    std::size_t bend = 0;
    for (std::size_t i = 1; i + 1 < looks.size(); ++i) {
      const auto& [place, fate] = looks[i];
      if (!is_border(fate.end)) continue;
      const double part = double(place - first.place) / (last.place - first.place);
      const double off = std::abs(fate.t - std::lerp(first.fate.t, last.fate.t, part)) * fate.speed;
      if (off > largest) largest = off, bend = i;
    }
    if (bend == 0) return;
    places.push_back(looks[bend].place);
    add_bends(looks.first(bend + 1), places);
    add_bends(looks.subspan(bend), places);
  }

  Fate fate(int look) {
    Trajectory path = source_.start(double(look) / seed_looks);
    if (path.exists()) path.skip_to(request_.duration, source_.sampler());
    const double speed = path.exists() ? magnitude(path.at(path.time()).v) : 0;
    return {path.end().value_or(EndReason::duration), path.time(), speed};
  }

  const SurfaceRequest& request_;
  SurfaceSetup setup_;
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
