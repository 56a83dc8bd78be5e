// SPDX-License-Identifier: GPL-3.0-or-later
// The points of an OpenVDB file: of each of its point grids, whatever its codecs. Numbers become
// scalars of their name; Houdini's colour `Cd` becomes red, green and blue.

#include <fmt/format.h>
#include <openvdb/points/PointDataGrid.h>

#include "fields/files/vdb_open.h"
#include "geometry/files/mesh_formats.h"

namespace pellucid::geometry {
namespace {

using openvdb::points::PointDataGrid;
using Leaf = PointDataGrid::TreeType::LeafNodeType;

/// Calls visit(value, coordinates of its voxel) for each of a leaf's points in active voxels.
template <class T>
void visit(const Leaf& leaf, const std::string& attribute, const auto& visit) {
  const openvdb::points::AttributeHandle<T> handle(leaf.constAttributeArray(attribute));
  for (auto i = leaf.beginIndexOn(); i; ++i) visit(handle.get(*i), i.getCoord());
}

template <class T>
void append(const Leaf& leaf, const std::string& attribute, std::vector<double>& values) {
  visit<T>(leaf, attribute, [&](const T& value, const auto&) { values.push_back(double(value)); });
}

void append_attribute(const Leaf& leaf, const std::string& name, VertexAttributes& attributes) {
  const std::string type = leaf.constAttributeArray(name).valueType();
  if (type == "float") append<float>(leaf, name, attributes[name]);
  if (type == "double") append<double>(leaf, name, attributes[name]);
  if (type == "int32") append<std::int32_t>(leaf, name, attributes[name]);
  if (type == "int64") append<std::int64_t>(leaf, name, attributes[name]);
  if (type == "vec3s" && name == "Cd")
    visit<openvdb::Vec3f>(leaf, name, [&](const openvdb::Vec3f& color, const auto&) {
      for (int channel = 0; channel < 3; ++channel)
        attributes[std::array{"red", "green", "blue"}[std::size_t(channel)]].push_back(
            color[channel]);
    });
}

struct Points {
  std::vector<Vec3> positions;
  VertexAttributes attributes;
};

void append_leaf(const Leaf& leaf, const openvdb::math::Transform& transform, Points& points) {
  visit<openvdb::Vec3f>(leaf, "P", [&](const openvdb::Vec3f& in_voxel, const openvdb::Coord& c) {
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
    return attribute.second.size() != points.positions.size();
  });
  return points;
}

PointSet read_vdb_points(const std::filesystem::path& path) {
  try {
    const auto file = fields::open_vdb(path);
    Points points = points_of(*file);
    PointSet set;
    set.positions = std::move(points.positions);
    take_attributes(std::move(points.attributes), set);
    return set;
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& error) {  // OpenVDB's, and the allocations of a damaged file
    throw InputError(fmt::format("{}: not a valid .vdb file: {}", path.string(), error.what()));
  }
}

}  // namespace

FormatRow vdb_format() {
  return {.ending = ".vdb", .title = "OpenVDB point grids", .read_points = read_vdb_points};
}

}  // namespace pellucid::geometry
