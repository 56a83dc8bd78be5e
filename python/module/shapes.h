// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "scene/files/object_file.h"

namespace pellucid::python {

/// A Shape is geometry that Python holds; what it is made of does not change any more, so that
/// arrays over it are shared.
struct Shape {
  std::shared_ptr<const scene::GivenShape> shape;

  const geometry::Vertices& vertices() const;
  /// Returns the key under which a scene file names such a shape: "mesh", "lines" or "points".
  std::string key() const;
};
/// A Mesh holds triangles.
struct Mesh : Shape {};
/// A Surface is a mesh that was integrated.
struct Surface : Mesh {
  nlohmann::ordered_json quality;  // see surface_json()
};
/// Lines hold polylines; `stats` say how they were integrated, if they were.
struct Lines : Shape {
  nlohmann::ordered_json stats;
};
/// Points hold points.
struct Points : Shape {};

/// Returns the Mesh, Lines or Points that the object is; nullptr when it is none.
const Shape* shape_in(const pybind11::handle& object);

/// Returns the shape of these vertices.
template <class Kind, class Geometry>
Kind shape_of(Geometry geometry) {
  Kind made;
  made.shape = std::make_shared<const scene::GivenShape>(std::move(geometry));
  return made;
}

/// Adds Mesh, Surface, Lines and Points to the module.
void define_shapes(pybind11::module_& module);

}  // namespace pellucid::python
