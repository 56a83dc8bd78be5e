// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Random scenes of every kind of primitive, with crossings at equal depths, for tests of parts.

#include <memory>
#include <random>
#include <string>

#include "tests/support/levels.h"
#include "tests/support/scenes.h"

namespace pellucid::testing {

/// A ScenesOfKind makes random objects of one kind.
struct ScenesOfKind {
  const char* name;
  scene::SceneObject (*object)(std::uint32_t seed);
};

namespace part_scenes {

/// The outlines of random triangles, a line each, with importance.
inline geometry::LineSet outlines(std::uint32_t seed) {
  const geometry::TriangleMesh mesh = random_triangles(40, seed);
  geometry::LineSet set;
  set.positions = mesh.positions;
  set.colors = mesh.colors;
  for (std::size_t i = 0; i < set.positions.size(); ++i) set.importance.push_back(float(i % 7) / 7);
  for (std::size_t end = 3; end <= set.positions.size(); end += 3) set.offsets.push_back(end);
  return set;
}

inline geometry::PointSet corners(std::uint32_t seed) {
  const geometry::TriangleMesh mesh = random_triangles(60, seed);
  geometry::PointSet set;
  set.positions = mesh.positions;
  set.colors = mesh.colors;
  return set;
}

/// Random triangles, slivers among them, with normals, and a sheet of a grid whose halves are
/// there twice: crossings at equal depth that only their numbers order.
inline scene::SceneObject triangles(std::uint32_t seed) {
  geometry::TriangleMesh mesh = random_triangles(80, seed);
  for (std::uint32_t i = 0; i < 20; ++i)  // as thin as a hundredth of their length
    mesh.positions[3 * i + 2] =
        mesh.positions[3 * i] + 1.01 * (mesh.positions[3 * i + 1] - mesh.positions[3 * i]);
  const auto first = std::uint32_t(mesh.positions.size());
  for (const Vec3& x : {Vec3(-1, -1, 0.1), Vec3(1, -1, 0.1), Vec3(1, 1, 0.1), Vec3(-1, 1, 0.1)}) {
    mesh.positions.push_back(x);
    mesh.colors.push_back(Rgba(0.25 * (x.x + 2), 0.25 * (x.y + 2), 0.5, 0.3));
  }
  for (int copy = 0; copy < 3; ++copy) {
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
  }
  std::mt19937 random(seed);
  std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), random);
  for (const Vec3& x : mesh.positions) mesh.normals.push_back(glm::normalize(x + Vec3(0, 0, 2)));
  return {"triangles", mesh};
}

inline scene::SceneObject ribbons(std::uint32_t seed) {
  return {"ribbons", scene::LineObject{outlines(seed), 0.05, scene::LineObject::Profile::ribbon}};
}
inline scene::SceneObject tubes(std::uint32_t seed) {
  return {"tubes", scene::LineObject{outlines(seed), 0.05, scene::LineObject::Profile::tube}};
}
inline scene::SceneObject discs(std::uint32_t seed) {
  return {"discs", scene::PointObject{corners(seed), 0.15, scene::PointObject::Profile::disc}};
}
inline scene::SceneObject spheres(std::uint32_t seed) {
  return {"spheres", scene::PointObject{corners(seed), 0.15, scene::PointObject::Profile::sphere}};
}

/// A wavy surface on two levels over [-1, 1]³, its opacity by the field itself.
inline scene::SceneObject isosurface(std::uint32_t seed) {
  const double phase = seed;
  const auto f = [&](const Vec3& x) {
    return std::sin(4 * x.x + phase) * std::cos(3 * x.y) + 0.5 * std::sin(5 * x.z);
  };
  scene::Isosurface surface;
  surface.field = std::make_shared<fields::LevelField>(
      std::vector<fields::ScalarLevel>{sampled(Vec3(-0.875), 0.25, 8, f),
                                       sampled(Vec3(-0.4375), 0.125, 8, f)},
      fields::reconstructions[0]);
  surface.value = 0.1;
  surface.corners = scene::corners_of(surface.field->bounds());
  surface.corners.colors.assign(8, Rgba(0.8, 0.4, 0.2, 0.35));
  return {"isosurface", surface};
}

inline scene::SceneObject opaque_spheres(std::uint32_t seed) {
  scene::SceneObject object = spheres(seed + 100);
  object.opaque = true;
  return object;
}
inline scene::SceneObject opaque_triangles(std::uint32_t seed) {
  scene::SceneObject object{"context", random_triangles(24, seed + 100, 0.8)};
  object.mesh().normals.assign(object.mesh().positions.size(), Vec3(0, 0, 1));
  object.opaque = true;
  return object;
}

}  // namespace part_scenes

inline constexpr ScenesOfKind kinds_of_parts[] = {
    {"triangles", part_scenes::triangles},
    {"ribbons", part_scenes::ribbons},
    {"tubes", part_scenes::tubes},
    {"discs", part_scenes::discs},
    {"spheres", part_scenes::spheres},
    {"isosurface", part_scenes::isosurface},
    {"opaque_spheres", part_scenes::opaque_spheres},
    {"opaque_triangles", part_scenes::opaque_triangles}};

/// A scene of one kind's objects; the second object is the first again, so that all of its
/// crossings have an equal in depth. Every other seed is lit, and orthographic.
inline scene::Scene scene_of_kind(const ScenesOfKind& kind, std::uint32_t seed) {
  scene::Scene scene;
  scene.name = kind.name;
  scene.width = 26;
  scene.height = 21;
  scene.background = {0.1, 0.5, 0.9};
  if (seed % 2 == 1) {
    scene.lighting = scene::Lighting::headlight;
    scene.camera.projection = scene::Projection::orthographic;
    scene.camera.height = 2.2;
  }
  scene.objects = {kind.object(seed), kind.object(seed)};
  return scene;
}

/// A scene of all kinds, the opaque ones last.
inline scene::Scene scene_of_all_kinds(std::uint32_t seed) {
  scene::Scene scene = scene_of_kind(kinds_of_parts[0], seed);
  scene.name = "all";
  for (const ScenesOfKind& kind : kinds_of_parts) scene.objects.push_back(kind.object(seed + 1));
  return scene;
}

}  // namespace pellucid::testing
