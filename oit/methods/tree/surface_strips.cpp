// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/methods/tree/surface_strips.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/parallel.h"
#include "integrators/front/front_particle.h"
#include "integrators/paths/backward.h"
#include "integrators/paths/carried.h"
#include "scene/elements/opacity_source.h"

namespace pellucid::oit {
namespace {

// Pixels between two vertices of a line: the chord of a circle of radius r pixels is 1.1 / r off.
constexpr double step = 3;

integrators::SurfaceRequest request_of(const scene::FlowSource& source) {
  return {source.field.get(), source.seed, source.duration, source.start_time, source.path, {}};
}

/// How far lines with seeds at a distance of 1 are apart across the flow, world units.
double separation_across(const integrators::FrontPoint& point) {
  const Vec3& w = point.flow.w;
  return glm::length(w - glm::dot(w, point.direction) * point.direction);
}

/// A strip while it grows.
class StripBuilder {
 public:
  StripBuilder(double s, bool with_normals) : s_(s), with_normals_(with_normals) {}

  void add(const integrators::FrontPoint& point, double time, double half_width) {
    // Where the surface has no normal, or the flow stands, it goes on as before.
    const Vec3 across = glm::cross(point.normal, point.direction);
    if (across != Vec3(0)) across_ = across, normal_ = point.normal;
    if (across_ == Vec3(0)) return;
    for (const double side : {-1., 1.})
      add(point.flow.x + side * half_width * across_, point, time);
    const auto n = std::uint32_t(mesh_.positions.size());
    if (n < 4) return;
    mesh_.triangles.push_back({n - 4, n - 3, n - 1});
    mesh_.triangles.push_back({n - 4, n - 1, n - 2});
  }

  geometry::TriangleMesh take() { return std::move(mesh_); }
  /// Where the line is, for each vertex: its strip may reach out of the field.
  const std::vector<Vec3>& places() const { return places_; }

 private:
  void add(const Vec3& x, const integrators::FrontPoint& point, double time) {
    mesh_.positions.push_back(x);
    places_.push_back(point.flow.x);
    if (with_normals_) mesh_.normals.push_back(normal_);
    mesh_.scalars["s"].push_back(s_);
    mesh_.scalars["t"].push_back(point.t);
    mesh_.scalars["time"].push_back(time);
    mesh_.scalars["speed"].push_back(point.speed);
  }

  double s_;
  bool with_normals_;
  Vec3 across_{0}, normal_{0};
  geometry::TriangleMesh mesh_;
  std::vector<Vec3> places_;
};

void append(const geometry::TriangleMesh& part, geometry::TriangleMesh& whole) {
  const auto base = std::uint32_t(whole.positions.size());
  const auto add = [](const auto& from, auto& to) {
    to.insert(to.end(), from.begin(), from.end());
  };
  add(part.positions, whole.positions);
  add(part.normals, whole.normals);
  add(part.colors, whole.colors);
  for (const auto& [a, b, c] : part.triangles)
    whole.triangles.push_back({base + a, base + b, base + c});
}

}  // namespace

const OptionTable<StripOptions>& strip_options() {
  static const OptionTable<StripOptions> table{
      number("line-width", &StripOptions::width,
             {.min = 0.01,
              .max = 100,
              .unit = "pixels",
              .help = "of a line's strip where the surface faces the eye"}),
      number("widest", &StripOptions::widest,
             {.min = 0,
              .max = 1000,
              .unit = "pixels",
              .help = "a strip widens so far to reach the next of all lines"}),
      choice("seeding", &StripOptions::seeding,
             {{"separation", LineSeeding::separation}, {"uniform", LineSeeding::uniform}},
             "more lines where neighbours part, or evenly many in s")};
  return table;
}

SurfaceStrips::SurfaceStrips(const scene::SceneObject& object, const scene::Scene& scene,
                             const scene::DepthRange& range, std::uint64_t lines,
                             const StripOptions& options)
    : source_(*object.source),
      line_count_(lines),
      options_(options),
      frame_(scene::camera_frame(scene.camera)),
      projection_(scene.camera.projection),
      half_width_(scene::half_height(scene.camera) * scene.width / scene.height),
      half_height_(scene::half_height(scene.camera)),
      pixel_(2 * half_height_ / scene.height),
      nearest_(0.01 * range.far),
      lit_(scene::lighting_of(scene, object) != scene::Lighting::none),
      request_(request_of(source_)),
      integration_(integrators::surface_setup(request_, integrators::SurfaceOptions{})),
      particles_(request_, integration_) {
  if (options.seeding == LineSeeding::separation)
    seeds_ = integrators::LineSeeds([&](double s) { return largest_separation(s); });
  if (scene::has_optimized_opacities(scene))
    mesh_opacity_.emplace(object.mesh(), source_.seed.closed);
}

double SurfaceStrips::pixel_size(const Vec3& x) const {
  if (projection_ == scene::Projection::orthographic) return pixel_;
  return pixel_ * std::max(scene::view_depth(frame_, x), nearest_);
}

bool SurfaceStrips::is_in_picture(const Vec3& x) const {
  const Vec3 p = x - frame_.eye;
  const double z = glm::dot(frame_.forward, p);
  const double scale = projection_ == scene::Projection::orthographic ? 1 : z;
  return z > 0 && std::abs(glm::dot(frame_.right, p)) <= scale * half_width_ &&
         std::abs(glm::dot(frame_.up, p)) <= scale * half_height_;
}

/// Calls visit(point, world units a pixel there) along a line.
template <class Visit>
void SurfaceStrips::follow(double s, Visit&& visit) {
  fields::FieldSampler& sampler = particles_.sampler();
  integrators::Trajectory path = particles_.start(s);
  const double longest = source_.duration / 20;
  for (double t = 0; path.exists();) {
    const integrators::FrontPoint point = integrators::front_point(path, t);
    const double pixel = pixel_size(point.flow.x);
    visit(point, pixel);
    path.release(t);
    const double wanted = t + std::min(step * pixel / point.speed, longest);
    path.reach(wanted, sampler);
    const double next = std::min(wanted, path.time());
    if (!(next > t)) break;
    t = next;
  }
}

/// Where the line is in the picture, in pixels.
double SurfaceStrips::largest_separation(double s) {
  double largest = 0;
  follow(s, [&](const integrators::FrontPoint& point, double pixel) {
    if (is_in_picture(point.flow.x)) largest = std::max(largest, separation_across(point) / pixel);
  });
  return largest;
}

geometry::TriangleMesh SurfaceStrips::line(const integrators::LineSeeds::Seed& seed) {
  StripBuilder strip(seed.s, lit_);
  // In s; see LineSeeds.
  const double gap = integrators::LineSeeds::largest_gap / (double(line_count_) * seed.density);
  follow(seed.s, [&](const integrators::FrontPoint& point, double pixel) {
    const double width = std::clamp(gap * separation_across(point), options_.width * pixel,
                                    std::max(options_.width, options_.widest) * pixel);
    const double time = source_.start_time + (source_.path ? point.t : 0);
    strip.add(point, time, 0.5 * width);
  });
  geometry::TriangleMesh mesh = strip.take();
  integrators::turn_back(mesh, *source_.field);
  if (source_.attributes) integrators::carry(*source_.attributes, strip.places(), mesh);
  scene::apply_appearance(source_.appearance, mesh);
  if (mesh_opacity_)
    for (std::size_t i = 0; i < mesh.colors.size(); ++i)
      mesh.colors[i].a = mesh_opacity_->at(seed.s, mesh.scalars["t"][i]);
  return mesh;
}

geometry::TriangleMesh SurfaceStrips::lines(std::uint64_t first, std::uint64_t count) {
  std::vector<geometry::TriangleMesh> strips(count);
  parallel_for(std::uint64_t(0), count,
               [&](std::uint64_t i) { strips[i] = line(seeds_.seed(first + i)); });
  geometry::TriangleMesh all;
  for (const geometry::TriangleMesh& strip : strips) append(strip, all);
  return all;
}

}  // namespace pellucid::oit
