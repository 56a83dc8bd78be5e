// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/views/rank_views.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/halo.h"
#include "scene/view/unit_scale.h"

namespace pellucid::compare {
namespace {

constexpr double least_angle = 30;  // degrees between two views
constexpr double highest = 70;      // degrees of elevation
constexpr int least_candidates = 32;

constexpr double degree = std::numbers::pi / 180;

/// Right-handed axes of which the last is up.
struct UpFrame {
  Vec3 east, north, up;

  explicit UpFrame(const Vec3& direction) : up(scene::normalized_or_zero(direction)) {
    Vec3 axis(0);
    int least = 0;
    for (int k = 1; k < 3; ++k)
      if (std::abs(up[k]) < std::abs(up[least])) least = k;
    axis[least] = 1;
    east = glm::normalize(axis - glm::dot(axis, up) * up);
    north = glm::cross(up, east);
  }
};

void make_small(scene::Scene& scene, int samples) {
  const double scale = double(samples) / std::max(scene.width, scene.height);
  scene.width = std::max(1, int(std::lround(scene.width * scale)));
  scene.height = std::max(1, int(std::lround(scene.height * scale)));
  scene.samples = {};
}

bool is_apart(const RankedView& view, const std::vector<RankedView>& chosen) {
  const auto toward = [](const RankedView& v) {
    return glm::normalize(v.camera.eye - v.camera.target);
  };
  return std::ranges::all_of(chosen, [&](const RankedView& other) {
    return glm::dot(toward(view), toward(other)) < std::cos(least_angle * degree);
  });
}

void weigh(std::vector<RankedView>& views) {
  double most_layers = 0, most_importance = 0;
  const auto layers = [](const RankedView& view) { return view.score.covered * view.score.layers; };
  for (const RankedView& view : views) {
    most_layers = std::max(most_layers, layers(view));
    most_importance = std::max(most_importance, view.score.importance);
  }
  for (RankedView& view : views) {
    view.worth = most_layers > 0 ? layers(view) / most_layers : 0;
    if (most_importance > 0) view.worth *= view.score.importance / most_importance;
  }
}

}  // namespace

std::vector<SphereView> sphere_views(int count, const Vec3& up) {
  const UpFrame frame(up);
  const double top = std::sin(highest * degree);
  constexpr double golden = std::numbers::pi * (3 - 2.2360679774997896964);  // of the full turn
  std::vector<SphereView> views;
  for (int i = 0; i < count; ++i) {
    const double height = top * (1 - (2 * i + 1.0) / count), ring = std::sqrt(1 - height * height);
    const double azimuth = std::fmod(golden * i, 2 * std::numbers::pi);
    const Vec3 toward = ring * std::cos(azimuth) * frame.east +
                        ring * std::sin(azimuth) * frame.north + height * frame.up;
    views.push_back({azimuth / degree, std::asin(height) / degree, {"", "", toward, up}});
  }
  return views;
}

std::vector<RankedView> rank_views(scene::Scene& scene, const scene::SceneCore& core, int count,
                                   int samples, const Progress& progress) {
  make_small(scene, samples);
  const Vec3 up = scene.camera.up;
  std::vector<RankedView> views;
  const int candidates = std::max(least_candidates, 3 * count);
  for (const SphereView& side : sphere_views(candidates, up)) {
    report(progress, double(views.size()) / candidates, "looking from all sides");
    scene.camera = scene::core_camera(scene, core, side.direction);
    scene::place_halos(scene);
    views.push_back({scene.camera, side.azimuth, side.elevation, view_score(scene)});
  }
  weigh(views);
  std::ranges::stable_sort(views, std::ranges::greater{}, &RankedView::worth);
  std::vector<RankedView> best;
  for (const RankedView& view : views)
    if (int(best.size()) < count && view.worth > 0 && is_apart(view, best)) best.push_back(view);
  return best;
}

}  // namespace pellucid::compare
