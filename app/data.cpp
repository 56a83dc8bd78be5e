// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "core/error.h"
#include "core/files/ending.h"
#include "core/files/files_read.h"
#include "core/files/json_text.h"
#include "core/options/names.h"
#include "fields/levels/vdb_levels.h"
#include "geometry/files/mesh_file.h"
#include "geometry/files/mesh_formats.h"
#include "scene/datasets/dataset.h"

namespace pellucid::app {
namespace {

/// Surfaces, lines and points are told apart once they are made.
bool is_written(const std::string& output) {
  const geometry::FormatRow* format = geometry::mesh_format(output);
  return format && (format->write_mesh || format->write_lines || format->write_points);
}

/// Before the work that would be in vain. Throws InputError with the names that are known, or the
/// endings that the data set takes.
void check(const std::string& dataset, const std::string& output) {
  const std::string name = parse_name_and_options(dataset).name;
  const scene::DatasetRow& row = find_row("data set", name, scene::datasets());
  const std::string ending = std::filesystem::path(output).extension().string();
  const bool fits = row.on_levels ? small_ending(output) == ".vdb" : is_written(output);
  if (!fits)
    throw InputError(fmt::format(
        "{}: ending '{}'; accepted for {}: {}", output, ending, name,
        row.on_levels ? ".vdb" : geometry::endings_with(&geometry::FormatRow::write_mesh)));
}

nlohmann::ordered_json write(const scene::VelocityLevels& levels, const std::string& output,
                             const std::string& /* its grids have no comment */) {
  fields::write_vdb_levels(output, "velocity", levels);
  nlohmann::ordered_json grids = nlohmann::ordered_json::array();
  for (const fields::VectorLevel& level : levels)
    grids.push_back({{"size", level.size},
                     {"width", level.width},
                     {"first", {level.origin.x, level.origin.y, level.origin.z}}});
  return {{"grids", grids}};
}

nlohmann::ordered_json write(const geometry::TriangleMesh& mesh, const std::string& output,
                             const std::string& origin) {
  geometry::write_mesh(output, mesh, origin);
  return {{"vertices", mesh.positions.size()}, {"triangles", mesh.triangles.size()}};
}

nlohmann::ordered_json write(const geometry::LineSet& lines, const std::string& output,
                             const std::string& origin) {
  geometry::write_lines(output, lines, origin);
  return {{"lines", lines.line_count()}, {"points", lines.positions.size()}};
}

nlohmann::ordered_json write(const geometry::PointSet& points, const std::string& output,
                             const std::string& origin) {
  geometry::write_points(output, points, origin);
  return {{"points", points.positions.size()}};
}

void make(const std::string& dataset, const std::string& output, const GlobalOptions& globals) {
  const ProtectedInputs inputs;
  check(dataset, output);
  const std::string origin = "pellucid data " + dataset;
  const nlohmann::ordered_json json =
      std::visit([&](const auto& data) { return write(data, output, origin); },
                 scene::make_dataset(dataset, console_progress(globals)));
  if (globals.json)
    std::cout << json_text(json, 2) << '\n';
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
                   fmt::format("Levels: .vdb; surfaces: {}; lines: {}; points: {}",
                               geometry::endings_with(&geometry::FormatRow::write_mesh),
                               geometry::endings_with(&geometry::FormatRow::write_lines),
                               geometry::endings_with(&geometry::FormatRow::write_points)))
      ->required();
  command->footer(
      "Examples:\n  pellucid data dark-sky:count=20000 -o stars.ply\n"
      "  pellucid data sphere-levels -o spheres.vdb");
  add_global_options(*command, globals);
  command->callback([dataset, output, &globals] { make(*dataset, *output, globals); });
}

}  // namespace pellucid::app
