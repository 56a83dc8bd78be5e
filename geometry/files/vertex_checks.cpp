// SPDX-License-Identifier: GPL-3.0-or-later
// What readers of all formats do with the attributes of vertices, and what they refuse.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "geometry/default_color.h"
#include "geometry/files/mesh_formats.h"

namespace pellucid::geometry {
namespace {

bool has_all(const VertexAttributes& attributes, std::initializer_list<const char*> names) {
  return std::all_of(names.begin(), names.end(),
                     [&](const char* name) { return attributes.contains(name); });
}

void check_unit_interval(const std::string& file, std::string_view name, std::size_t vertex,
                         double value) {
  if (!(value >= 0 && value <= 1))
    throw InputError(
        fmt::format("{}: vertex {}: {} is {}; accepted: 0 … 1", file, vertex, name, value));
}

}  // namespace

bool has_rgb(const VertexAttributes& attributes) {
  return has_all(attributes, {"red", "green", "blue"});
}

std::vector<Rgba> take_colors(VertexAttributes& attributes, std::size_t count) {
  const auto take = [&](const char* name, double otherwise) {
    auto node = attributes.extract(name);
    return node.empty() ? std::vector<double>(count, otherwise) : std::move(node.mapped());
  };
  const bool colored = has_rgb(attributes);
  if (!colored && !has_all(attributes, {"alpha"})) return {};
  const auto alpha = take("alpha", 1);
  std::vector<Rgba> colors;
  colors.reserve(count);
  if (!colored) {
    for (const double a : alpha) colors.emplace_back(default_color, a);
    return colors;
  }
  const auto red = take("red", 0), green = take("green", 0), blue = take("blue", 0);
  for (std::size_t i = 0; i < count; ++i) colors.emplace_back(red[i], green[i], blue[i], alpha[i]);
  return colors;
}

void take_attributes(VertexAttributes attributes, Vertices& vertices) {
  const std::size_t count = vertices.positions.size();
  const auto take = [&](const char* name) { return std::move(attributes.extract(name).mapped()); };
  vertices.colors = take_colors(attributes, count);
  if (has_all(attributes, {"nx", "ny", "nz"})) {
    const auto x = take("nx"), y = take("ny"), z = take("nz");
    vertices.normals.resize(count);
    for (std::size_t i = 0; i < count; ++i) vertices.normals[i] = Vec3(x[i], y[i], z[i]);
  }
  if (has_all(attributes, {"importance"})) {
    const auto g = take("importance");
    vertices.importance.assign(g.begin(), g.end());
  }
  vertices.scalars = std::move(attributes);
}

void check_vertices(const std::string& file, const Vertices& vertices) {
  for (std::size_t i = 0; i < vertices.positions.size(); ++i)
    for (int axis = 0; axis < 3; ++axis)
      if (const double x = vertices.positions[i][axis]; !(std::abs(x) < coordinate_limit))
        throw InputError(fmt::format("{}: vertex {}: {} is {}; accepted: finite numbers below {:g}",
                                     file, i, "xyz"[axis], x, coordinate_limit));
  static constexpr std::string_view channel[] = {"red", "green", "blue", "alpha"};
  for (std::size_t i = 0; i < vertices.colors.size(); ++i)
    for (int c = 0; c < 4; ++c) check_unit_interval(file, channel[c], i, vertices.colors[i][c]);
  for (std::size_t i = 0; i < vertices.importance.size(); ++i)
    check_unit_interval(file, "importance", i, vertices.importance[i]);
}

void check_mesh(const std::string& file, const TriangleMesh& mesh) {
  check_vertices(file, mesh);
  const std::size_t count = mesh.positions.size();
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for (const std::uint32_t index : mesh.triangles[i])
      if (index >= count)
        throw InputError(
            fmt::format("{}: triangle {}: vertex index {} of {} vertices", file, i, index, count));
  if (mesh.triangles.empty()) throw InputError(file + ": no triangles; accepted: at least one");
}

}  // namespace pellucid::geometry
