// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "core/error.h"
#include "core/options/names.h"
#include "fields/levels/vdb_levels.h"
#include "geometry/files/mesh_file.h"
#include "scene/datasets/dataset.h"

namespace pellucid::app {
namespace {

/// Before the work that would be in vain. Throws InputError with the names that are known, or the
/// endings that the data set takes.
void check(const std::string& dataset, const std::string& output) {
  const std::string name = parse_name_and_options(dataset).name;
  const scene::DatasetRow& row = find_row("data set", name, scene::datasets());
  const std::string ending = std::filesystem::path(output).extension().string();
  const bool fits =
      row.on_levels ? ending == ".vdb" : ending == ".ply" || ending == ".obj" || ending == ".vtp";
  if (!fits)
    throw InputError(fmt::format("{}: ending '{}'; accepted for {}: {}", output, ending, name,
                                 row.on_levels ? ".vdb" : ".ply, .obj, .vtp"));
}

nlohmann::ordered_json write(const scene::VelocityLevels& levels, const std::string& output) {
  fields::write_vdb_levels(output, "velocity", levels);
  nlohmann::ordered_json grids = nlohmann::ordered_json::array();
  for (const fields::VectorLevel& level : levels)
    grids.push_back({{"size", level.size},
                     {"width", level.width},
                     {"first", {level.origin.x, level.origin.y, level.origin.z}}});
  return {{"grids", grids}};
}

nlohmann::ordered_json write(const geometry::TriangleMesh& mesh, const std::string& output) {
  geometry::write_mesh(output, mesh);
  return {{"vertices", mesh.positions.size()}, {"triangles", mesh.triangles.size()}};
}

nlohmann::ordered_json write(const geometry::LineSet& lines, const std::string& output) {
  geometry::write_lines(output, lines);
  return {{"lines", lines.line_count()}, {"points", lines.positions.size()}};
}

/// The vertices of a mesh without triangles.
nlohmann::ordered_json write(const geometry::PointSet& points, const std::string& output) {
  if (std::filesystem::path(output).extension() != ".ply")
    throw InputError(output + ": accepted for points: .ply");
  geometry::write_mesh(output, geometry::TriangleMesh{geometry::Vertices(points), {}});
  return {{"points", points.positions.size()}};
}

void make(const std::string& dataset, const std::string& output, const GlobalOptions& globals) {
  check(dataset, output);
  const nlohmann::ordered_json json =
      std::visit([&](const auto& data) { return write(data, output); },
                 scene::make_dataset(dataset, console_progress(globals)));
  if (globals.json)
    std::cout << json.dump(2) << '\n';
  else if (!globals.quiet)
    for (const auto& [key, value] : json.items()) std::cout << key << ": " << value << '\n';
}

}  // namespace

void add_data_command(CLI::App& app, GlobalOptions& globals) {
  CLI::App* command = app.add_subcommand("data", "Write a generated data set into a file");
  const auto dataset = std::make_shared<std::string>(), output = std::make_shared<std::string>();
  command->add_option("NAME", *dataset, "NAME[:key=value,...]; see 'list datasets'")->required();
  command
      ->add_option("-o,--output", *output,
                   "Levels: .vdb; surfaces and lines: .ply, .obj or .vtp; points: .ply")
      ->required();
  add_global_options(*command, globals);
  command->callback([dataset, output, &globals] { make(*dataset, *output, globals); });
}

}  // namespace pellucid::app
