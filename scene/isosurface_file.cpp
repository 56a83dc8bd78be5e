#include "scene/isosurface_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

#include "fields/derived_scalar.h"
#include "fields/level_field.h"
#include "fields/sphere_levels.h"
#include "fields/surface_extraction.h"
#include "fields/vdb_levels.h"

namespace pellucid {
namespace {

constexpr double any = std::numeric_limits<double>::max();

std::vector<ScalarLevel> read_levels(const JsonNode& node, const std::filesystem::path& folder) {
  const std::string scalar = node["scalar"].string();
  if (node.has("dataset") == node.has("file")) node.fail("accepted: one of the keys file, dataset");
  if (node.has("dataset")) {
    const JsonNode dataset = node["dataset"];
    const auto levels = at_place(dataset, [&] { return make_sphere_levels(dataset.string()); });
    return at_place(node["scalar"], [&] { return scalars_of(levels, scalar); });
  }
  const JsonNode file = node["file"];
  std::vector<ScalarLevel> levels;
  for (const JsonNode& name : file.is_array() ? file.elements() : std::vector{file})
    at_place(name, [&] {
      for (ScalarLevel& level : read_vdb_levels(folder / name.string(), scalar))
        levels.push_back(std::move(level));
    });
  return levels;
}

/// Triangles with a corner in the hole are left out.
TriangleMesh mesh_of(const Isosurface& surface) {
  ExtractedSurface extracted = extract_surface(*surface.field, surface.value);
  TriangleMesh mesh;
  mesh.positions = std::move(extracted.positions);
  mesh.normals = std::move(extracted.normals);
  std::ranges::copy_if(extracted.triangles, std::back_inserter(mesh.triangles), [&](const auto& t) {
    return std::ranges::none_of(
        t, [&](std::uint32_t corner) { return surface.cuts_away(mesh.positions[corner]); });
  });
  return mesh;
}

std::string describe(const LevelField& field, const std::string& scalar) {
  std::vector<std::string> sizes;
  for (const ScalarLevel& level : field.levels())
    sizes.push_back(fmt::format("{}", fmt::join(level.size, " × ")));
  return fmt::format("{} on {} samples, {}", scalar, fmt::join(sizes, " and "),
                     field.reconstruction().name);
}

}  // namespace

std::variant<Isosurface, TriangleMesh> read_isosurface(const JsonNode& node,
                                                       const std::filesystem::path& folder,
                                                       std::string& how) {
  node.accept_keys({"file", "dataset", "scalar", "value", "reconstruction", "hole", "mesh"});
  const auto& reconstruction = at_place(node, [&]() -> const ReconstructionRow& {
    return find_reconstruction(node.has("reconstruction") ? node["reconstruction"].string()
                                                          : "blend");
  });
  Isosurface surface;
  surface.value = node["value"].number(-any, any);
  std::vector<ScalarLevel> levels = read_levels(node, folder);
  surface.field = at_place(
      node, [&] { return std::make_shared<const LevelField>(std::move(levels), reconstruction); });
  surface.corners = corners_of(surface.field->bounds());
  if (node.has("hole")) {
    const JsonNode hole = node["hole"];
    hole.accept_keys({"center", "radius"});
    surface.hole = {hole["center"].vec3(), hole["radius"].number(0, any)};
  }
  how = describe(*surface.field, node["scalar"].string());
  if (!node.has("mesh") || !node["mesh"].boolean()) return surface;
  TriangleMesh mesh = at_place(node, [&] { return mesh_of(surface); });
  if (mesh.triangles.empty()) node.fail("nothing to draw: it has no triangle");
  how += fmt::format(", {} triangles", mesh.triangles.size());
  return mesh;
}

}  // namespace pellucid
