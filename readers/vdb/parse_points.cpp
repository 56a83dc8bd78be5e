// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <openvdb/points/PointDataGrid.h>

#include <array>
#include <map>

#include "core/vec.h"
#include "readers/vdb/parse_vdb.h"
#include "readers/vdb/vdb_open.h"

namespace pellucid::readers {
namespace {

/// An attribute's numbers, point after point.
struct Column {
  std::uint32_t components = 1;
  std::vector<double> values;
};
using Columns = std::map<std::string, Column>;
using openvdb::points::PointDataGrid;
using Leaf = PointDataGrid::TreeType::LeafNodeType;

/// Calls visit(value, coordinates of its voxel) for each of a leaf's points in active voxels.
template <class T>
void for_each_point(const Leaf& leaf, const std::string& attribute, const auto& visit) {
  const openvdb::points::AttributeHandle<T> handle(leaf.constAttributeArray(attribute));
  for (auto i = leaf.beginIndexOn(); i; ++i) visit(handle.get(*i), i.getCoord());
}

template <class T>
void append(const Leaf& leaf, const std::string& attribute, Column& column) {
  for_each_point<T>(leaf, attribute,
                    [&](const T& value, const auto&) { column.values.push_back(double(value)); });
}

template <class T>
void append_vectors(const Leaf& leaf, const std::string& attribute, Column& column) {
  column.components = 3;
  for_each_point<T>(leaf, attribute, [&](const T& value, const auto&) {
    for (int c = 0; c < 3; ++c) column.values.push_back(double(value[c]));
  });
}

void append_color(const Leaf& leaf, const std::string& attribute, Columns& columns) {
  for_each_point<openvdb::Vec3f>(leaf, attribute, [&](const openvdb::Vec3f& color, const auto&) {
    for (int channel = 0; channel < 3; ++channel)
      columns[std::array{"red", "green", "blue"}[std::size_t(channel)]].values.push_back(
          color[channel]);
  });
}

void append_attribute(const Leaf& leaf, const std::string& name, Columns& attributes) {
  const std::string type = leaf.constAttributeArray(name).valueType();
  if (type == "float") append<float>(leaf, name, attributes[name]);
  if (type == "double") append<double>(leaf, name, attributes[name]);
  if (type == "int32") append<std::int32_t>(leaf, name, attributes[name]);
  if (type == "int64") append<std::int64_t>(leaf, name, attributes[name]);
  if (type == "vec3s" && name == "Cd")
    append_color(leaf, name, attributes);
  else if (type == "vec3s")
    append_vectors<openvdb::Vec3f>(leaf, name, attributes[name]);
  if (type == "vec3d") append_vectors<openvdb::Vec3d>(leaf, name, attributes[name]);
}

struct Points {
  std::vector<Vec3> positions;
  Columns attributes;
};

void append_leaf(const Leaf& leaf, const openvdb::math::Transform& transform, Points& points) {
  for_each_point<openvdb::Vec3f>(
      leaf, "P", [&](const openvdb::Vec3f& in_voxel, const openvdb::Coord& c) {
        const openvdb::Vec3d x = transform.indexToWorld(c.asVec3d() + openvdb::Vec3d(in_voxel));
        points.positions.emplace_back(x.x(), x.y(), x.z());
      });
  for (const auto& [name, place] : leaf.attributeSet().descriptor().map())
    if (name != "P") append_attribute(leaf, name, points.attributes);
}

Points points_of(openvdb::io::File& file) {
  Points points;
  for (auto name = file.beginName(); name != file.endName(); ++name) {
    const auto grid = openvdb::gridPtrCast<PointDataGrid>(file.readGrid(*name));
    if (!grid) continue;
    for (auto leaf = grid->tree().cbeginLeaf(); leaf; ++leaf)
      append_leaf(*leaf, grid->transform(), points);
  }
  // What only some of the grids have belongs to none of the points.
  std::erase_if(points.attributes, [&](const auto& attribute) {
    const auto& [components, values] = attribute.second;
    return values.size() != components * points.positions.size();
  });
  return points;
}

}  // namespace

void parse_vdb_points(const std::filesystem::path& path, BlockWriter& out) {
  const auto file = open_vdb(path);
  const Points points = points_of(*file);
  out.add("positions", NumberType::f64, 3, points.positions.size(), points.positions.data());
  for (const auto& [name, column] : points.attributes)
    out.add("column:" + name, std::span<const double>(column.values), column.components);
}

}  // namespace pellucid::readers
