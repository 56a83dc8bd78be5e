// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/front/seed_features.h"

#include <algorithm>
#include <cmath>
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

/// Follows particles from looks, to tell which of them last for the whole duration.
class Followed {
 public:
  Followed(const SurfaceRequest& request, const SurfaceSetup& setup)
      : request_(request), source_(request, setup), lasts_(followed_looks + 1) {
    parallel_for(0, followed_looks + 1, [&](int i) { lasts_[std::size_t(i)] = lasts(i * stride); });
  }

  std::uint64_t evaluations() const { return source_.evaluations(); }

  /// Adds the two neighbouring looks between which a particle that lasts and one that does not lie.
  void add_edges(std::vector<int>& places) {
    for (int i = 0; i < followed_looks; ++i) {
      if (lasts_[std::size_t(i)] == lasts_[std::size_t(i) + 1]) continue;
      int low = i * stride, high = low + stride;
      while (high - low > 1) {
        const int middle = (low + high) / 2;
        (lasts(middle) == lasts_[std::size_t(i)] ? low : high) = middle;
      }
      places.insert(places.end(), {low, high});
    }
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
  }

 private:
  static constexpr int stride = seed_looks / followed_looks;

  char lasts(int look) {
    Trajectory path = source_.start(double(look) / seed_looks);
    return path.exists() && path.reach(request_.duration, source_.sampler());
  }

  const SurfaceRequest& request_;
  ParticleSource source_;
  std::vector<char> lasts_;
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
