// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/error.h"
#include "fields/field.h"
#include "geometry/line_set.h"
#include "geometry/point_set.h"
#include "geometry/triangle_mesh.h"
#include "integrators/paths/seed_curve.h"
#include "scene/appearance/appearance.h"
#include "scene/appearance/lighting.h"
#include "scene/isosurface.h"
#include "scene/opacity_energy.h"
#include "scene/view/camera.h"
#include "scene/view/pixel_samples.h"
#include "scene/view/radii.h"

namespace pellucid::fields {
class Attributes;
}

namespace pellucid::scene {

/// A Halo is the band around a line that hides what lies far behind it; place_halos() makes its
/// triangles.
struct Halo {
  double width = 0;           // beyond the ribbon's rim, world
  double depth = 0;           // by which its outer rim lies behind the line, world
  std::optional<Vec3> color;  // none: the background's
};

/// A LineObject holds polylines of a width. A ribbon faces the eye at every point (see ribbon.h)
/// and is lit as the tube that it stands for: at the fraction c of the half width,
///   |n · v| = √(1 - c²) |m · v|
/// with m the part of v that is perpendicular to the line, normalized. The line's direction is that
/// of line_direction() at its points, normalized, and interpolated linearly between them.
struct LineObject {
  /// A Profile says whether lines are flat strips or round.
  enum class Profile { ribbon, tube };

  geometry::LineSet set;
  Radii radius;  // half a ribbon's width; of a tube, see TubeGeometry
  Profile profile = Profile::ribbon;
  std::optional<Halo> halo = std::nullopt;
};

/// A PointObject holds points of a size. A disc is parallel to the picture, so that all of it has
/// its centre's view depth and its picture is round; it is lit as the sphere that it stands for: at
/// the fraction c of the radius, |n · v| = √(1 - c²).
struct PointObject {
  /// A Profile says whether points are flat discs or spheres.
  enum class Profile { disc, sphere };

  geometry::PointSet set;
  Radii radius;  // a point of radius 0 is not drawn
  Profile profile = Profile::disc;
};

/// A FlowSource is what a surface was integrated from, for methods that draw lines of their own on
/// it. Times are in the field's units.
struct FlowSource {
  std::shared_ptr<const fields::VectorField> field;
  integrators::SeedCurve seed;
  double duration = 0;
  double start_time = 0;
  bool path = false;  // a path surface of an unsteady field, not a stream surface
  std::shared_ptr<const fields::Attributes> attributes;  // of its files, that `appearance` is by
  Appearance appearance;  // of the surface, its colour's range filled in
};

/// A SceneObject is one thing of the scene, ready to be drawn: colours are always filled in,
/// normals of a mesh where it is lit.
struct SceneObject {
  std::string name;  // where it comes from, for messages and the report
  std::variant<geometry::TriangleMesh, LineObject, PointObject, Isosurface> shape;
  bool opaque = false;  // hides what lies behind it, whatever its alpha; context of the others
  std::optional<FlowSource> source = std::nullopt;
  bool is_halo = false;                             // made by place_halos()
  std::optional<Lighting> lighting = std::nullopt;  // its own; none: the scene's

  const geometry::Vertices& vertices() const;
  geometry::Vertices& vertices() {
    return const_cast<geometry::Vertices&>(std::as_const(*this).vertices());
  }
  /// Returns the shape, which has to be a mesh.
  const geometry::TriangleMesh& mesh() const { return std::get<geometry::TriangleMesh>(shape); }
  geometry::TriangleMesh& mesh() { return std::get<geometry::TriangleMesh>(shape); }
  /// Returns how wide its vertices are drawn: those of a mesh or of an isosurface 0.
  const Radii& radii() const;
  /// Returns the box of all that is drawn, widths included, in world units.
  Box3 bounds() const;
};

/// A SceneView says how objects are drawn; the picture is `width` × `height` pixels.
struct SceneView {
  int width = 1000;
  int height = 1000;
  PixelSampling samples;
  Camera camera;
  Vec3 background{1, 1, 1};  // red, green, blue in [0, 1]
  Lighting lighting = Lighting::none;
  EnergyWeights energy;  // for methods that optimize opacities
};

/// A Scene says what is drawn and how. Objects are ordered: crossings at equal depth are ordered by
/// object, then by primitive: triangle; triangle of a ribbon (two a segment, see ribbon.h);
/// segment; point; cell of an isosurface.
struct Scene : SceneView {
  std::string name;
  std::string file;  // that it was read from, for messages; empty: none
  std::vector<SceneObject> objects;
  std::vector<Camera> camera_path;                // empty: none; `camera` need not be on it
  std::map<std::string, std::string> provenance;  // how the objects were made

  /// Returns the box of all objects, in world units.
  Box3 bounds() const;
};

/// Returns how an object is lit in a view.
inline Lighting lighting_of(const SceneView& view, const SceneObject& object) {
  return object.lighting.value_or(view.lighting);
}
/// Returns how all objects are lit; nothing where they differ.
std::optional<Lighting> common_lighting(const Scene& scene);
/// Returns whether any object is lit.
inline bool is_lit(const Scene& scene) { return common_lighting(scene) != Lighting::none; }

/// Returns whether any transparent object has importance: without, no opacity is optimized.
bool has_importance(const Scene& scene);

/// Throws the InputError with the scene's file before it, where it has one and the error does not
/// name it.
[[noreturn]] void fail_at(const Scene& scene, const InputError& error);

/// Returns what the objects consist of: "384000 triangles, 12 lines of 6000 segments".
std::string describe_primitives(const Scene& scene);

}  // namespace pellucid::scene
