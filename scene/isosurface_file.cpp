#include "scene/isosurface_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "fields/derived_scalar.h"
#include "fields/level_field.h"
#include "fields/sphere_levels.h"
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

std::string describe(const LevelField& field, const std::string& scalar) {
  std::vector<std::string> sizes;
  for (const ScalarLevel& level : field.levels())
    sizes.push_back(fmt::format("{}", fmt::join(level.size, " × ")));
  return fmt::format("{} on {} samples, {}", scalar, fmt::join(sizes, " and "),
                     field.reconstruction().name);
}

}  // namespace

Isosurface read_isosurface(const JsonNode& node, const std::filesystem::path& folder,
                           std::string& how) {
  node.accept_keys({"file", "dataset", "scalar", "value", "reconstruction", "hole"});
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
  return surface;
}

}  // namespace pellucid
