// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "core/error.h"
#include "core/files/files_read.h"
#include "core/files/json_text.h"
#include "core/files/output_file.h"
#include "core/options/lower_case.h"
#include "core/parallel.h"
#include "geometry/files/mesh_file.h"
#include "groundtruth/queries/ray_query.h"

namespace pellucid::app {
namespace {

using groundtruth::FreeRay;
using groundtruth::RayHit;

struct CrossingsArguments {
  std::string mesh, rays, output;
};

/// The columns x y z and dx dy dz of a table.
std::vector<FreeRay> read_rays(const std::string& file) {
  geometry::PointSet table = geometry::read_points(file);
  const auto column = [&](std::string_view name) -> const std::vector<double>& {
    const auto found = std::ranges::find_if(
        table.scalars, [&](const auto& scalar) { return lower_case(scalar.first) == name; });
    if (found == table.scalars.end())
      throw InputError(
          fmt::format("{}: the column {} is missing; accepted: x, y, z, dx, dy, dz", file, name));
    return found->second;
  };
  const auto &dx = column("dx"), &dy = column("dy"), &dz = column("dz");
  std::vector<FreeRay> rays;
  for (std::size_t i = 0; i < table.positions.size(); ++i)
    rays.push_back({table.positions[i], Vec3(dx[i], dy[i], dz[i])});
  return rays;
}

using Hits = std::vector<std::vector<RayHit>>;

/// Each ray's crossings. A ray that is refused is named, from 0 as in the output.
Hits find(const groundtruth::RayQuery& query, const std::string& file,
          const std::vector<FreeRay>& rays) {
  Hits hits(rays.size());
  parallel_for(std::size_t(0), rays.size(), [&](std::size_t i) {
    try {
      hits[i] = query.all(rays[i]);
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: ray {}: {}", file, i, error.what()));
    }
  });
  return hits;
}

std::string csv_of(const Hits& hits) {
  std::string csv = "ray,t,triangle,u,v,side\n";
  for (std::size_t i = 0; i < hits.size(); ++i)
    for (const RayHit& hit : hits[i])
      csv += fmt::format("{},{},{},{},{},{}\n", i, hit.t, hit.triangle, hit.u, hit.v, hit.side);
  return csv;
}

nlohmann::json to_json(const std::vector<RayHit>& hits) {
  nlohmann::json crossings = nlohmann::json::array();
  for (const RayHit& hit : hits)
    crossings.push_back(
        {{"t", hit.t}, {"triangle", hit.triangle}, {"u", hit.u}, {"v", hit.v}, {"side", hit.side}});
  return {{"count", hits.size()}, {"odd", hits.size() % 2 == 1}, {"crossings", crossings}};
}

void run(const CrossingsArguments& arguments, const GlobalOptions& globals) {
  const ProtectedInputs inputs;
  const groundtruth::RayQuery query(geometry::read_mesh(arguments.mesh));
  const Hits hits = find(query, arguments.rays, read_rays(arguments.rays));
  if (!arguments.output.empty()) write_text(arguments.output, csv_of(hits));
  if (!globals.json) {
    if (arguments.output.empty()) fmt::print("{}", csv_of(hits));
    return;
  }
  nlohmann::json json{{"rays", nlohmann::json::array()}};
  for (const auto& of_ray : hits) json["rays"].push_back(to_json(of_ray));
  fmt::print("{}\n", json_text(json, 1));
}

}  // namespace

void add_crossings_command(CLI::App& app, GlobalOptions& globals) {
  const auto arguments = std::make_shared<CrossingsArguments>();
  CLI::App* command =
      app.add_subcommand("crossings", "Find every crossing of any rays with a mesh, exactly");
  command->add_option("MESH", arguments->mesh, "File of triangles; see 'list formats'")->required();
  command
      ->add_option(
          "--rays", arguments->rays,
          "Table (.csv) of rays: columns x, y, z (origin) and dx, dy, dz (direction of any "
          "length)")
      ->required();
  command->add_option("-o,--output", arguments->output,
                      "Table of crossings: ray and triangle (from 0), t, u, v, side; without: "
                      "printed");
  command->footer(
      "A crossing is origin + t * direction, t >= 0 (a ray that begins on a triangle begins on one "
      "side\nof it, and crosses it in one direction alone); u and v weigh the triangle's second "
      "and "
      "third vertex;\nside is 1 along its normal, -1 against. An edge or a vertex is crossed once; "
      "a ray "
      "whose number\nof crossings is odd begins inside a closed mesh.\n"
      "Example:\n  pellucid crossings part.ply --rays rays.csv -o crossings.csv");
  add_global_options(*command, globals);
  command->callback([arguments, &globals] { run(*arguments, globals); });
}

}  // namespace pellucid::app
