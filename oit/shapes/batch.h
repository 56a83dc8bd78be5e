// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "scene/scene.h"

namespace pellucid::oit {

/// A ShapeKind says how OpenGL draws a shape: as triangles that are the shape (meshes, ribbons,
/// discs), or by casting the ray of each pixel: at solids (spheres, tubes), or at the pieces of
/// isosurfaces, along a ray of degree three or, where levels fade, of a higher one.
enum class ShapeKind { mesh, ribbon, disc, sphere, tube, isosurface, fading_isosurface };

/// The table holds every kind, in order.
inline constexpr std::array shape_kinds = {ShapeKind::mesh,
                                           ShapeKind::ribbon,
                                           ShapeKind::disc,
                                           ShapeKind::sphere,
                                           ShapeKind::tube,
                                           ShapeKind::isosurface,
                                           ShapeKind::fading_isosurface};

/// Returns the kind of an object, of an isosurface the first of its two.
ShapeKind kind_of(const scene::SceneObject& object);

/// Returns whether a kind is solid, and has two crossings a unit: where they enter,
/// then where they leave.
constexpr bool is_solid(ShapeKind kind) {
  return kind == ShapeKind::sphere || kind == ShapeKind::tube;
}

/// Returns whether a kind is drawn by casting the ray of each pixel.
constexpr bool is_cast(ShapeKind kind) {
  return is_solid(kind) || kind == ShapeKind::isosurface || kind == ShapeKind::fading_isosurface;
}

/// Returns the number of primitives of a unit, which is thinned out as one: two of a segment or a
/// sphere, one of a triangle or a disc.
constexpr std::uint32_t primitives_of_unit(ShapeKind kind) {
  return kind == ShapeKind::ribbon || is_solid(kind) ? 2 : 1;
}

/// Returns the number of triangles of a mesh, of triangles of ribbons (two a segment), of discs, or
/// of crossings of solids (two a sphere, or a segment of a tube). For an isosurface, whose
/// crossings depend on the camera (see Isosurfaces), it is how many are told apart where depths are
/// equal.
std::uint64_t primitive_count(const scene::SceneObject& object);

/// A PrimitiveRange is an object's place in the order of a scene: the numbers of its first and its
/// last primitive, counted from object to object.
struct PrimitiveRange {
  std::uint32_t first, last;
};

/// Returns the place of every object. Throws InputError for 2^31 / 3 primitives or more.
std::vector<PrimitiveRange> primitive_ranges(const scene::Scene& scene);

/// A Batch is a run of primitives of one kind that follow each other in the scene.
struct Batch {
  ShapeKind kind = ShapeKind::mesh;
  bool opaque = false;
  scene::Lighting lighting = scene::Lighting::none;
  std::uint32_t first_primitive = 0;                  // in the order of the scene, see scene.h
  std::uint32_t last_primitive = 0;                   // what would follow it counts as this
  std::uint32_t first_of_kind = 0, last_of_kind = 0;  // likewise, among those of its kind
  std::uint32_t first = 0;                            // in the buffer of its kind
  std::uint32_t count = 0;                            // 0 of an isosurface until it is cut
  /// What first_of_kind counts, in units, plus this is the number of triangles, segments and points
  /// before it that are transparent.
  std::int64_t passed = 0;
  /// The points before it that are drawn by the other kind of points, or likewise the segments:
  /// elements count points and segments whatever their kind.
  std::uint32_t others = 0;
};

/// Returns the batches of a scene whose objects have these places in the order of the scene that
/// they are a part of, or its own. Each isosurface has a batch. Throws InputError as
/// primitive_ranges().
///@{
std::vector<Batch> make_batches(const scene::Scene& part, std::span<const PrimitiveRange> places);
std::vector<Batch> make_batches(const scene::Scene& scene);
///@}

}  // namespace pellucid::oit
