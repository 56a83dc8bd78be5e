// SPDX-License-Identifier: GPL-3.0-or-later
#include "module/shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "core/error.h"
#include "geometry/files/mesh_file.h"
#include "geometry/files/mesh_formats.h"
#include "geometry/vertex_normals.h"
#include "module/values.h"
#include "module/work.h"

namespace pellucid::python {
namespace {

using geometry::LineSet;
using geometry::PointSet;
using geometry::TriangleMesh;

/// What a vertex may carry, as Python gives it; None where it has none.
struct Attributes {
  py::object normals, colors, importance, scalars;
};

template <class T>
void check_count(const std::vector<T>& values, std::size_t count, std::string_view what) {
  if (values.size() != count)
    throw InputError(fmt::format("{}: {} rows; accepted: one for each of {} vertices", what,
                                 values.size(), count));
}

std::vector<double> scalar_of(const py::handle& value, std::size_t count, const std::string& what) {
  const auto array = numbers_of(value, 0, what);
  std::vector<double> values(array.data(), array.data() + array.size());
  check_count(values, count, what);
  return values;
}

void set_normals(const py::handle& value, geometry::Vertices& vertices, const std::string& kind) {
  vertices.normals = vectors_of(value, kind + ": normals");
  check_count(vertices.normals, vertices.positions.size(), kind + ": normals");
}

void set_scalars(const py::handle& value, geometry::Vertices& vertices, const std::string& kind) {
  if (!is_mapping(value))
    throw InputError(kind + ": scalars; accepted: a dict of names and arrays");
  for (const auto& [key, values] : py::dict(py::reinterpret_borrow<py::object>(value))) {
    const std::string name = text_of(key, kind + ": scalars: a name");
    vertices.scalars[name] =
        scalar_of(values, vertices.positions.size(), fmt::format("{}: scalars['{}']", kind, name));
  }
}

void set_vertices(const py::handle& positions, const Attributes& attributes,
                  geometry::Vertices& vertices, const std::string& kind) {
  vertices.positions = vectors_of(positions, kind + ": vertices");
  const std::size_t count = vertices.positions.size();
  if (count == 0) throw InputError(kind + ": vertices: none; accepted: at least one");
  if (!attributes.normals.is_none()) set_normals(attributes.normals, vertices, kind);
  if (!attributes.colors.is_none()) {
    vertices.colors = colors_of(attributes.colors, 2, kind + ": colors");
    check_count(vertices.colors, count, kind + ": colors");
  }
  if (!attributes.importance.is_none()) {
    const auto values = scalar_of(attributes.importance, count, kind + ": importance");
    vertices.importance.assign(values.begin(), values.end());
  }
  if (!attributes.scalars.is_none()) set_scalars(attributes.scalars, vertices, kind);
}

std::uint32_t index_of(std::int64_t number, std::size_t vertices, std::size_t triangle) {
  constexpr auto most = std::int64_t(std::numeric_limits<std::uint32_t>::max());
  const std::int64_t end = std::min(std::int64_t(vertices), most);
  if (number < 0 || number >= end)
    throw InputError(
        fmt::format("Mesh: triangles[{}]: vertex {}; accepted: 0 … {}", triangle, number, end - 1));
  return std::uint32_t(number);
}

Mesh make_mesh(const py::object& vertices, const py::object& triangles, const py::object& normals,
               const py::object& colors, const py::object& importance, const py::object& scalars) {
  TriangleMesh mesh;
  set_vertices(vertices, {normals, colors, importance, scalars}, mesh, "Mesh");
  const auto corners = integers_of(triangles, 3, "Mesh: triangles");
  mesh.triangles.resize(std::size_t(corners.shape(0)));
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      mesh.triangles[i][k] = index_of(corners.data()[3 * i + k], mesh.positions.size(), i);
  geometry::check_mesh("Mesh", mesh);
  geometry::mend_normals(mesh);
  return shape_of<Mesh>(std::move(mesh));
}

std::vector<std::uint64_t> offsets_of(const py::handle& value, std::size_t count) {
  if (value.is_none()) return {0, count};
  const auto array = integers_of(value, 0, "Lines: offsets");
  std::vector<std::uint64_t> offsets(array.data(), array.data() + array.size());
  const bool ends_fit = offsets.size() >= 2 && offsets.front() == 0 && offsets.back() == count;
  if (!ends_fit || !std::ranges::is_sorted(offsets))
    throw InputError(
        fmt::format("Lines: offsets; accepted: ascending numbers from 0 to {}, the "
                    "number of vertices",
                    count));
  return offsets;
}

Lines make_lines(const py::object& vertices, const py::object& offsets, const py::object& normals,
                 const py::object& colors, const py::object& importance,
                 const py::object& scalars) {
  LineSet lines;
  set_vertices(vertices, {normals, colors, importance, scalars}, lines, "Lines");
  lines.offsets = offsets_of(offsets, lines.positions.size());
  geometry::check_vertices("Lines", lines);
  geometry::make_unit(lines.normals);
  return shape_of<Lines>(std::move(lines));
}

Points make_points(const py::object& vertices, const py::object& colors,
                   const py::object& importance, const py::object& scalars) {
  PointSet points;
  set_vertices(vertices, {py::none(), colors, importance, scalars}, points, "Points");
  geometry::check_vertices("Points", points);
  return shape_of<Points>(std::move(points));
}

/// An array over a part of the shape; None where there is none.
template <class Number, class Item>
py::object over(const Shape& shape, const std::vector<Item>& items) {
  if (items.empty()) return py::none();
  const auto columns = py::ssize_t(sizeof(Item) / sizeof(Number));
  std::vector<py::ssize_t> array{py::ssize_t(items.size())};
  if (columns > 1) array.push_back(columns);
  return array_over(shape.shape, reinterpret_cast<const Number*>(items.data()), std::move(array));
}

py::dict scalars_of(const Shape& shape) {
  py::dict scalars;
  for (const auto& [name, values] : shape.vertices().scalars)
    scalars[py::str(name)] = over<double>(shape, values);
  return scalars;
}

void save(const Shape& shape, const py::object& path) {
  const std::string file = path_of(path, "save: path");
  run_unlocked([&](const Progress&) {
    if (const auto* mesh = std::get_if<TriangleMesh>(shape.shape.get()))
      geometry::write_mesh(file, *mesh);
    if (const auto* lines = std::get_if<LineSet>(shape.shape.get()))
      geometry::write_lines(file, *lines);
    if (const auto* points = std::get_if<PointSet>(shape.shape.get()))
      geometry::write_points(file, *points);
  });
}

template <class Kind>
void define_vertices(py::class_<Kind>& kind) {
  kind.def_property_readonly(
          "vertices", [](const Kind& s) { return over<double>(s, s.vertices().positions); },
          "Positions, world units: float64 (N, 3).")
      .def_property_readonly(
          "colors", [](const Kind& s) { return over<float>(s, s.vertices().colors); },
          "Straight red, green, blue and opacity in [0, 1]: float32 (N, 4); None without.")
      .def_property_readonly(
          "importance", [](const Kind& s) { return over<float>(s, s.vertices().importance); },
          "Importance g in [0, 1]: float32 (N,); None without.")
      .def_property_readonly(
          "scalars", [](const Kind& s) { return scalars_of(s); },
          "Numbers of the vertices by name: a dict of float64 (N,).")
      .def(
          "save", [](const Kind& s, const py::object& path) { save(s, path); }, py::arg("path"),
          "Writes a file by its ending, such as .ply or .vtp. Raises InputError for another.");
}

template <class Kind>
void define_normals(py::class_<Kind>& kind) {
  kind.def_property_readonly(
      "normals", [](const Kind& s) { return over<double>(s, s.vertices().normals); },
      "Unit vectors: float64 (N, 3); None without.");
}

constexpr const char* mesh_doc = R"(Triangles from NumPy arrays.

vertices: (N, 3), world units. triangles: (M, 3), indices of vertices from 0. normals: (N, 3).
colors: (N, 3) or (N, 4), straight red, green, blue and opacity, floats in [0, 1] or uint8 as n/255.
importance: (N,), in [0, 1]. scalars: a dict of (N,) by name, by which a scene may colour.
The arrays are copied once; those that it returns are read-only and shared. Raises InputError.)";

constexpr const char* lines_doc = R"(Polylines from NumPy arrays.

vertices: (N, 3), world units. offsets: (K + 1,), line k joins vertices offsets[k] to offsets[k + 1] - 1;
None: one line through all. The others as for Mesh. Raises InputError.)";

constexpr const char* points_doc = R"(Points from NumPy arrays.

vertices: (N, 3), world units. The others as for Mesh. Raises InputError.)";

std::string text(const Mesh& mesh, const char* name) {
  const auto& triangles = std::get<TriangleMesh>(*mesh.shape).triangles;
  return fmt::format("<pellucid.{}: {} vertices, {} triangles>", name,
                     mesh.vertices().positions.size(), triangles.size());
}

std::string text(const Lines& lines) {
  return fmt::format("<pellucid.Lines: {} lines, {} vertices>",
                     std::get<LineSet>(*lines.shape).line_count(),
                     lines.vertices().positions.size());
}

void define_mesh(py::module_& module) {
  const py::object none = py::none();
  py::class_<Mesh> mesh(module, "Mesh", mesh_doc);
  mesh.def(py::init(&make_mesh), py::arg("vertices"), py::arg("triangles"), py::kw_only(),
           py::arg("normals") = none, py::arg("colors") = none, py::arg("importance") = none,
           py::arg("scalars") = none);
  define_vertices(mesh);
  define_normals(mesh);
  mesh.def_property_readonly(
          "triangles",
          [](const Mesh& m) {
            return over<std::uint32_t>(m, std::get<TriangleMesh>(*m.shape).triangles);
          },
          "Three indices of vertices each: uint32 (M, 3).")
      .def("__repr__", [](const Mesh& m) { return text(m, "Mesh"); });
  py::class_<Surface, Mesh>(module, "Surface", "A mesh that trace() has integrated.")
      .def_property_readonly(
          "quality", [](const Surface& s) { return python_of(s.quality); },
          "What it took and how sound its mesh is, a dict; what it means: `pellucid trace --json`.")
      .def("__repr__", [](const Surface& s) { return text(s, "Surface"); });
}

void define_lines(py::module_& module) {
  const py::object none = py::none();
  py::class_<Lines> lines(module, "Lines", lines_doc);
  lines.def(py::init(&make_lines), py::arg("vertices"), py::arg("offsets") = none, py::kw_only(),
            py::arg("normals") = none, py::arg("colors") = none, py::arg("importance") = none,
            py::arg("scalars") = none);
  define_vertices(lines);
  define_normals(lines);
  lines
      .def_property_readonly(
          "offsets",
          [](const Lines& l) {
            return over<std::uint64_t>(l, std::get<LineSet>(*l.shape).offsets);
          },
          "Where lines begin and end among the vertices: uint64 (K + 1,).")
      .def_property_readonly(
          "stats", [](const Lines& l) { return python_of(l.stats); },
          "What trace() took for them, a dict; None when it has not made them.")
      .def("__repr__", [](const Lines& l) { return text(l); });
}

void define_points(py::module_& module) {
  const py::object none = py::none();
  py::class_<Points> points(module, "Points", points_doc);
  points.def(py::init(&make_points), py::arg("vertices"), py::kw_only(), py::arg("colors") = none,
             py::arg("importance") = none, py::arg("scalars") = none);
  define_vertices(points);
  points.def("__repr__", [](const Points& p) {
    return fmt::format("<pellucid.Points: {} points>", p.vertices().positions.size());
  });
}

}  // namespace

const geometry::Vertices& Shape::vertices() const {
  return std::visit([](const auto& kind) -> const geometry::Vertices& { return kind; }, *shape);
}

std::string Shape::key() const {
  static constexpr const char* keys[] = {"mesh", "lines", "points"};
  return keys[shape->index()];
}

const Shape* shape_in(const py::handle& object) {
  if (py::isinstance<Mesh>(object)) return object.cast<const Mesh*>();
  if (py::isinstance<Lines>(object)) return object.cast<const Lines*>();
  if (py::isinstance<Points>(object)) return object.cast<const Points*>();
  return nullptr;
}

void define_shapes(py::module_& module) {
  define_mesh(module);
  define_lines(module);
  define_points(module);
}

}  // namespace pellucid::python
