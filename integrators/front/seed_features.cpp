// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/front/seed_features.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/parallel.h"
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
      if (there) largest_speed_ = std::max(largest_speed_, glm::length(v));
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
      const double bend = glm::distance(*velocities_[std::size_t(i)], line);
      if (bend > largest) largest = bend, found = i;
    }
    return found;
  }

 private:
  std::vector<std::optional<Vec3>> velocities_;
  double largest_speed_ = 0;
};

/// Adds the middle of each stretch of looks of one kind that has none of the places.
template <class Kind>
void add_stretches(const Kind& kind_of, std::vector<int>& places) {
  std::vector<int> middles;
  for (int begin = 0, end; begin <= seed_looks; begin = end) {
    for (end = begin + 1; end <= seed_looks && kind_of(end) == kind_of(begin);) ++end;
    const auto first = std::lower_bound(places.begin(), places.end(), begin);
    if (first == places.end() || *first >= end) middles.push_back((begin + end - 1) / 2);
  }
  places.insert(places.end(), middles.begin(), middles.end());
  std::sort(places.begin(), places.end());
}

/// Of particles from s = i / followed_looks: whether each lasts for the whole duration.
std::vector<char> who_lasts(const SurfaceRequest& request, const SurfaceSetup& setup) {
  ParticleSource source(request, setup);
  std::vector<char> lasts(followed_looks + 1);
  parallel_for(0, followed_looks + 1, [&](int i) {
    Trajectory path = source.start(double(i) / followed_looks);
    lasts[std::size_t(i)] = path.exists() && path.reach(request.duration, source.sampler());
  });
  return lasts;
}

void add_bends(const Looks& looks, int a, int b, std::vector<int>& places) {
  const std::optional<int> bend = looks.largest_bend_between(a, b);
  if (!bend) return;
  places.push_back(*bend);
  add_bends(looks, a, *bend, places);
  add_bends(looks, *bend, b, places);
}

}  // namespace

std::vector<double> seed_features(const SurfaceRequest& request, const SurfaceSetup& setup,
                                  std::span<const double> seeds) {
  const Looks looks(request);
  const std::vector<char> lasts = who_lasts(request, setup);
  std::vector<int> places;
  for (const double s : seeds) places.push_back(int(std::lround(s * seed_looks)));
  const std::vector<int> known = places;
  add_stretches([&](int i) { return looks.is_there(i); }, places);
  add_stretches(
      [&](int i) {
        return lasts[std::size_t(std::lround(double(i) * followed_looks / seed_looks))];
      },
      places);
  const std::vector<int> between = places;
  for (std::size_t i = 1; i < between.size(); ++i)
    add_bends(looks, between[i - 1], between[i], places);
  std::vector<double> features;
  for (const int place : places)
    if (!std::ranges::binary_search(known, place)) features.push_back(double(place) / seed_looks);
  std::sort(features.begin(), features.end());
  return features;
}

}  // namespace pellucid::integrators
