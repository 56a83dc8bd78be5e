// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/trace_seeds.h"
#include "compare/methods/distance_picture.h"
#include "compare/pictures/image_file.h"
#include "compare/results/surface_json.h"
#include "core/error.h"
#include "core/files/files_read.h"
#include "core/files/json_text.h"
#include "core/options/names.h"
#include "fields/make_field.h"
#include "fields/reversed_field.h"
#include "geometry/files/mesh_file.h"
#include "geometry/files/mesh_formats.h"
#include "integrators/lines/integrate_lines.h"
#include "integrators/mesh/mesh_distance.h"
#include "integrators/mesh/mesh_quality.h"
#include "integrators/paths/backward.h"
#include "integrators/surfaces/integrate_surface.h"
#include "integrators/surfaces/surface_error.h"

namespace pellucid::app {
namespace {

struct TraceOptions {
  std::string field, integrator, output;
  SeedTexts seed;
  double duration = 0;
  bool both = false;
  double start_time = 0;
  bool path = false;
  std::uint64_t samples = 500;
  std::string error_picture;
  std::string against;
};

nlohmann::ordered_json to_json(const integrators::OneSidedDistance& distance) {
  return {{"mean", distance.mean}, {"rms", distance.rms}, {"max", distance.max}};
}

/// Of the surface from that of another integrator, and the other way round.
void add_distance_between(nlohmann::ordered_json& json, const TraceOptions& options,
                          const geometry::TriangleMesh& mesh,
                          const integrators::SurfaceRequest& request) {
  const geometry::TriangleMesh other =
      integrators::integrate_surface(options.against, request).mesh;
  report(request.progress, 1, "measuring the distance between the two surfaces");
  const auto [from_this, from_other] = integrators::mesh_distance(mesh, other, options.samples);
  json["against"] = {{"integrator", options.against},
                     {"from_this", to_json(from_this)},
                     {"from_other", to_json(from_other)}};
}

void print_summary(const std::string& output, const nlohmann::ordered_json& json) {
  std::cout << output << '\n';
  for (const auto& [key, value] : json.items()) std::cout << "  " << key << ": " << value << '\n';
}

void print(const TraceOptions& options, const GlobalOptions& globals,
           const nlohmann::ordered_json& json) {
  if (globals.json)
    std::cout << json_text(json, 2) << '\n';
  else if (!globals.quiet)
    print_summary(options.output, json);
}

/// From above the front right corner, all of the surface in view.
void write_error_picture(const std::string& file, const geometry::TriangleMesh& mesh,
                         const std::vector<double>& distances) {
  scene::Scene view;
  view.camera = scene::fitted_camera(mesh.bounds());
  compare::write_image(file, compare::distance_picture(view, mesh, distances).image);
}

void trace_surface(const TraceOptions& options, const GlobalOptions& globals,
                   const std::shared_ptr<const fields::VectorField>& field) {
  const auto way = options.duration < 0 ? fields::reversed(field, options.start_time) : field;
  integrators::SurfaceRequest request;
  request.field = way.get();
  request.seed = surface_seed(options.seed);
  request.duration = std::abs(options.duration);
  request.start_time = options.start_time;
  request.path = options.path;
  request.progress = console_progress(globals);
  integrators::IntegratedSurface surface =
      integrators::integrate_surface(options.integrator, request);
  nlohmann::ordered_json json =
      compare::surface_json(surface, integrators::measure_quality(surface.mesh));
  if (options.samples > 0) {
    report(request.progress, 1, "measuring the distance to the exact surface");
    integrators::SurfaceError error =
        integrators::measure_error(surface.mesh, request, options.samples,
                                   integrators::integrator_parameters(options.integrator));
    compare::add_error_json(json, error);
    if (!options.error_picture.empty())
      write_error_picture(options.error_picture, surface.mesh, error.at_vertices);
    surface.mesh.scalars["error"] = std::move(error.at_vertices);
  }
  if (!options.against.empty()) add_distance_between(json, options, surface.mesh, request);
  integrators::turn_back(surface.mesh, *way);
  json["field"] = way->description();
  geometry::write_mesh(options.output, surface.mesh);
  print(options, globals, json);
}

void trace_lines(const TraceOptions& options, const GlobalOptions& globals,
                 const fields::VectorField& field) {
  integrators::LineRequest request;
  request.field = &field;
  request.seeds = line_seeds(options.seed, options.integrator);
  request.duration = options.duration;
  request.start_time = options.start_time;
  request.both = options.both;
  const integrators::IntegratedLines lines =
      integrators::integrate_lines(options.integrator, request);
  geometry::write_lines(options.output, lines.lines);
  nlohmann::ordered_json json = compare::lines_json(lines);
  json["field"] = field.description();
  print(options, globals, json);
}

/// Is the integrator one of lines? Throws InputError that lists those of both kinds.
bool draws_lines(std::string_view integrator) {
  const std::string name = parse_name_and_options(integrator).name;
  std::vector<std::string_view> known;
  for (const integrators::IntegratorRow& row : integrators::integrators())
    known.push_back(row.name);
  for (const integrators::LineIntegratorRow& row : integrators::line_integrators())
    known.push_back(row.name);
  const auto found = std::find(known.begin(), known.end(), name);
  if (found == known.end()) throw InputError(unknown_name("integrator", name, known));
  return std::size_t(found - known.begin()) >= integrators::integrators().size();
}

void trace(const TraceOptions& options, const GlobalOptions& globals) {
  const ProtectedInputs inputs;
  const std::shared_ptr<const fields::VectorField> field = fields::make_field(options.field);
  if (options.both && !draws_lines(options.integrator))
    throw InputError("--both: accepted: with an integrator of lines; of a surface run each way");
  const bool measures = options.samples > 0 && !draws_lines(options.integrator);
  for (const auto& [name, value] : {std::pair("--error-picture", &options.error_picture),
                                    std::pair("--against", &options.against)})
    if (!value->empty() && !measures)
      throw InputError(
          fmt::format("{}: accepted: with a surface and --samples of at least 1", name));
  if (options.path && draws_lines(options.integrator))
    integrators::check_runs_along("--path", options.integrator);
  if (draws_lines(options.integrator))
    trace_lines(options, globals, *field);
  else
    trace_surface(options, globals, field);
}

}  // namespace

void add_trace_command(CLI::App& app, GlobalOptions& globals) {
  CLI::App* command =
      app.add_subcommand("trace", "Integrate a surface or lines, write them, print their quality");
  const auto options = std::make_shared<TraceOptions>();
  command->add_option("--field", options->field, "NAME[:key=value,...] or FILE")->required();
  command
      ->add_option("--integrator", options->integrator,
                   "NAME[:key=value,...]; see 'list integrators'")
      ->required();
  command->add_option("--seed", options->seed.seed, "Polyline X,Y,Z:X,Y,Z[:...] of the seeds");
  command->add_option("--seeds", options->seed.seeds,
                      "Instead: circle:center=X,Y,Z,radius=R,normal=X,Y,Z; of lines "
                      "grid:from=X,Y,Z,to=X,Y,Z,count=NX,NY,NZ; or a FILE of points, of lines one "
                      "each and else joined, or of one polyline");
  command->add_flag("--closed", options->seed.closed, "Join the polyline's ends");
  command
      ->add_option("--duration", options->duration,
                   "Time to integrate, not 0; below 0 back in time")
      ->required()
      ->check(finite_number());
  command->add_flag("--both", options->both, "Lines: as far back in time, too, as one line");
  command->add_option("--start-time", options->start_time, "The field's time at the seeds")
      ->check(finite_number());
  command->add_flag("--path", options->path,
                    "Path surface, or path lines: the field's time runs along");
  command
      ->add_option("-o,--output", options->output,
                   fmt::format("Surfaces: {}; lines: {}",
                               geometry::endings_with(&geometry::FormatRow::write_mesh),
                               geometry::endings_with(&geometry::FormatRow::write_lines)))
      ->required();
  command
      ->add_option(
          "--samples", options->samples,
          "Points where the distance to the exact surface is measured; 0: none. The mesh's "
          "scalar 'error' is the largest near each vertex")
      ->check(CLI::Range(0, int(integrators::most_error_samples)));
  command->add_option(
      "--error-picture", options->error_picture,
      "Picture of the distance on the surface, from a millionth of its size (black) "
      "to a hundredth");
  command->add_option("--against", options->against,
                      "Another integrator for the same surface, a finer one for instance: prints "
                      "how far the two are apart, both ways");
  command->footer(
      "Examples:\n"
      "  pellucid trace --field abc --integrator hultquist:threshold=0.05 \\\n"
      "      --seed 2.6,3.1,3.1:3.6,3.1,3.1 --duration 4 -o surface.ply\n"
      "  pellucid trace --field winds.nc:array=u,v,time=last \\\n"
      "      --integrator stream-lines:particles=1 --seed 10,45,0 --duration 3 --both -o line.vtp\n"
      "  pellucid trace --field abc --integrator stream-lines --duration 2 -o lines.vtp \\\n"
      "      --seeds grid:from=0,0,0,to=6,6,6,count=5,5,5\n"
      "What may stand behind a file's name: docs/fields.md; formats: pellucid list formats.");
  add_global_options(*command, globals);
  command->callback([options, &globals] { trace(*options, globals); });
}

}  // namespace pellucid::app
