// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Scenes of spheres and tubes.

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "tests/compare/methods/promise_scenes.h"

namespace pellucid::compare {

inline scene::SceneObject spheres(std::vector<Vec3> centers, double radius,
                                  std::vector<Rgba> colors) {
  scene::PointObject points;
  points.radius = radius;
  points.profile = scene::PointObject::Profile::sphere;
  points.set.positions = std::move(centers);
  points.set.colors = std::move(colors);
  return {"spheres", std::move(points)};
}

inline scene::SceneObject tube(std::vector<Vec3> line, double radius, std::vector<Rgba> colors) {
  scene::LineObject lines;
  lines.radius = radius;
  lines.profile = scene::LineObject::Profile::tube;
  lines.set.offsets = {0, line.size()};
  lines.set.positions = std::move(line);
  lines.set.colors = std::move(colors);
  return {"tube", std::move(lines)};
}

/// A tube of a radius at each point.
inline scene::SceneObject tube(std::vector<Vec3> line, std::vector<double> radii,
                               std::vector<Rgba> colors) {
  scene::SceneObject object = tube(std::move(line), 0.0, std::move(colors));
  std::get<scene::LineObject>(object.shape).radius = scene::Radii(std::move(radii));
  return object;
}

/// Makes objects of any place and colour in [-1, 1]³.
class RandomSolids {
 public:
  explicit RandomSolids(unsigned seed) : random_(seed) {}

  scene::SceneObject any_spheres(int count, double radius) {
    std::vector<Vec3> centers(std::size_t(count), Vec3(0));
    for (Vec3& x : centers) x = any();
    return spheres(centers, radius, colors(centers.size()));
  }
  /// A walk with sharp turns, whose parts overlap and which meets itself.
  scene::SceneObject any_tube(int points, double radius) {
    std::vector<Vec3> line{any()};
    while (int(line.size()) < points) line.push_back(line.back() + 0.3 * any());
    return tube(line, radius, colors(line.size()));
  }
  /// Gives each point of an object a radius between 0 and twice that of all, a sixth of them 0.
  scene::SceneObject tapered(scene::SceneObject object) {
    std::vector<double> radii;
    for (std::size_t i = 0; i < object.vertices().positions.size(); ++i)
      radii.push_back(object.radii().at(i) * std::max(0.0, 0.8 + 1.2 * unit_(random_)));
    std::visit(
        [&](auto& shape) {
          if constexpr (requires { shape.radius; }) shape.radius = scene::Radii(std::move(radii));
        },
        object.shape);
    return object;
  }
  Vec3 any() { return Vec3(unit_(random_), unit_(random_), unit_(random_)); }

 private:
  std::vector<Rgba> colors(std::size_t count) {
    std::vector<Rgba> list(count);
    for (Rgba& color : list) color = Rgba(0.5 + 0.5 * any(), 0.5 + 0.4 * unit_(random_));
    return list;
  }

  std::mt19937 random_;
  std::uniform_real_distribution<double> unit_{-1, 1};
};

/// A SolidScene is a scene with a name; of spheres and tubes alone, or of other shapes, too.
struct SolidScene {
  const char* name;
  bool solids_alone;
  scene::Scene (*make)();
};

/// Before an eye at a distance of 3, in 40 × 30 pixels.
inline scene::Scene some_solids() {
  RandomSolids random(3);
  scene::Scene scene = testing::empty_scene(40, 30);
  scene.camera = {.eye = {0, 0, 3}, .target = {0, 0, 0}};
  for (int i = 0; i < 4; ++i) {
    scene.objects.push_back(random.any_spheres(5, 0.1 + 0.08 * i));
    scene.objects.push_back(random.any_tube(12, 0.04 + 0.03 * i));
  }
  return scene;
}

inline scene::Scene mixed_with_others() {
  scene::Scene scene = some_solids();
  for (const scene::SceneObject& triangle : triangle_cloud(40, 30, 10, 12).objects)
    scene.objects.push_back(triangle);
  RandomSolids random(4);
  scene::SceneObject discs = random.any_spheres(5, 0.2), ribbon = random.any_tube(6, 0.1);
  std::get<scene::PointObject>(discs.shape).profile = scene::PointObject::Profile::disc;
  std::get<scene::LineObject>(ribbon.shape).profile = scene::LineObject::Profile::ribbon;
  scene.objects.insert(scene.objects.begin() + 1, {discs, ribbon});
  return scene;
}

/// Tubes whose own surfaces coincide: an orbit that closes, a particle that rests, a line there and
/// back; and a ball on a vertex. What lies at equal depth differs in colour.
inline scene::Scene coincident_solids() {
  scene::Scene scene = testing::empty_scene(60, 45);
  scene.camera = {.eye = {1.5, 1.2, 4}, .target = {0, 0, 0}, .fov = 40};
  const auto add = [&](const std::vector<Vec3>& line, double radius) {
    std::vector<Rgba> colors;
    for (std::size_t i = 0; i < line.size(); ++i) {
      const float t = float(i) / float(line.size() - 1);
      colors.emplace_back(t, 0.2f, 1 - t, 0.6f);
    }
    scene.objects.push_back(tube(line, radius, colors));
  };
  std::vector<Vec3> orbit, rest, back;
  for (int i = 0; i < 24; ++i) {
    const double a = 2 * std::numbers::pi * i / 23, s = i / 23.0;
    orbit.emplace_back(std::cos(a), std::sin(a), 0.1 * std::sin(2 * a));
    rest.emplace_back(s - 1, 0.3 * s, 0.1 * s + 1);
    back.emplace_back(s, 0.2 * std::sin(3 * s), 0.3 * s - 1);
  }
  orbit.back() = orbit.front();
  rest.insert(rest.begin() + 12, 6, rest[12]);
  back.insert(back.end(), back.rbegin() + 1, back.rend());
  add(orbit, 0.3);
  add(rest, 0.15);
  add(back, 0.1);
  scene.objects.push_back(spheres({rest.front()}, 0.15, {{0.9, 0.9, 0.1, 0.5}}));
  return scene;
}

/// The same, each point of a radius of its own, and what is special about cones: one along the
/// rays, balls that hold others, an end that is a tip, and one between tips that is nothing. No ray
/// of a pixel grazes a ball or runs into a tip, which rounding would decide.
inline scene::Scene tapered_solids() {
  RandomSolids random(6);
  scene::Scene scene = some_solids();
  for (scene::SceneObject& object : scene.objects) object = random.tapered(std::move(object));
  const Rgba color(0.9, 0.2, 0.4, 0.3);
  scene.objects.push_back(
      tube({{0, 0, 1}, {0, 0, 0}, {0, 0, -1}}, {0.05, 0.4, 0}, std::vector<Rgba>(3, color)));
  scene.objects.push_back(tube({{0.5, 0.2, 0}, {0.6, 0.2, 0}, {0.55, 0.3, 0.1}}, {0.4, 0.1, 0.05},
                               std::vector<Rgba>(3, color)));
  scene.objects.push_back(tube({{-0.89, 0.48, 0}, {-0.51, 0.48, 0}, {-0.2, 0.48, 0}, {0, 0.48, 0}},
                               {0.2, 0, 0, 0.1}, std::vector<Rgba>(4, color)));
  return scene;
}

inline std::vector<SolidScene> solid_scenes() {
  return {{"Perspective", true, some_solids},
          {"Parallel", true,
           [] {
             scene::Scene scene = some_solids();
             scene.camera.projection = scene::Projection::orthographic;
             scene.camera.height = 2;
             return scene;
           }},
          {"FromWithin", true,
           [] {
             scene::Scene scene = some_solids();
             scene.camera.eye = {0.05, 0, 0};
             scene.camera.target = {1, 0.2, 0.1};
             scene.camera.fov = 100;
             RandomSolids random(9);
             scene.objects.push_back(spheres({{0, 0, 0}}, 0.4, {{0.9, 0.2, 0.4, 0.3}}));
             scene.objects.push_back(tube({{-1, 0.1, 0}, {0, 0, 0}, {0.5, 0.5, 0}}, 0.2,
                                          {{0, 0, 1, 0.5}, {1, 0, 0, 0.5}, {0, 1, 0, 0.5}}));
             return scene;
           }},
          {"Lit", true,
           [] {
             scene::Scene scene = some_solids();
             scene.lighting = scene::Lighting::phong;
             return scene;
           }},
          {"TinyAndFar", true,
           [] {
             scene::Scene scene = some_solids();
             for (scene::SceneObject& object : scene.objects) {
               for (Vec3& x : object.vertices().positions) x = 1e-4 * x + Vec3(70, -20, 5);
               if (auto* points = std::get_if<scene::PointObject>(&object.shape))
                 points->radius *= 1e-4;
               else
                 std::get<scene::LineObject>(object.shape).radius *= 1e-4;
             }
             scene.camera.eye = {70, -20, 100};
             scene.camera.target = {70, -20, 5};
             scene.camera.fov = 2e-4 / 95 * 57.3;
             return scene;
           }},
          {"Tapered", true, tapered_solids},
          {"TaperedParallel", true,
           [] {
             scene::Scene scene = tapered_solids();
             scene.camera.projection = scene::Projection::orthographic;
             scene.camera.height = 2;
             scene.lighting = scene::Lighting::phong;
             return scene;
           }},
          {"TaperedFromWithin", true,
           [] {
             scene::Scene scene = tapered_solids();
             scene.camera.eye = {0.05, 0, 0};
             scene.camera.target = {1, 0.2, 0.1};
             scene.camera.fov = 100;
             scene.objects.push_back(tube({{-1, 0.1, 0}, {0, 0, 0}, {0.5, 0.5, 0}}, {0.1, 0.3, 0},
                                          std::vector<Rgba>(3, {0, 0, 1, 0.5})));
             return scene;
           }},
          {"Opaque", true,
           [] {
             scene::Scene scene = some_solids();
             scene.objects[2].opaque = scene.objects[5].opaque = true;
             return scene;
           }},
          {"Coincident", true, coincident_solids},
          {"Samples", true,
           [] {
             scene::Scene scene = some_solids();
             scene.samples.per_axis = 2;
             return scene;
           }},
          {"Mixed", false, mixed_with_others},
          {"MixedTapered", false, [] {
             RandomSolids random(8);
             scene::Scene scene = mixed_with_others();
             for (scene::SceneObject& object : scene.objects)
               object = random.tapered(std::move(object));
             return scene;
           }}};
}

}  // namespace pellucid::compare
