// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

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
#include "fields/make_field.h"
#include "fields/readers/attributes.h"
#include "fields/reversed_field.h"
#include "geometry/files/mesh_file.h"
#include "geometry/files/mesh_formats.h"
#include "integrators/integrator_kind.h"
#include "integrators/lines/integrate_lines.h"
#include "integrators/mesh/mesh_distance.h"
#include "integrators/mesh/mesh_quality.h"
#include "integrators/paths/backward.h"
#include "integrators/paths/carried.h"
#include "integrators/sheets/integrate_sheet.h"
#include "integrators/sheets/sheet_error.h"
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
  std::optional<std::uint64_t> samples;
  std::uint64_t error_samples() const { return samples.value_or(500); }
  std::string error_picture;
  std::string against;
  std::vector<std::string> carry;
};

nlohmann::ordered_json to_json(const integrators::OneSidedDistance& distance) {
  return {{"mean", distance.mean}, {"rms", distance.rms}, {"max", distance.max}};
}

/// What was traced, as a call: without the file, the threads and what is printed, so that the same
/// geometry is the same file.
std::string origin_of(const TraceOptions& options) {
  std::string call = fmt::format("pellucid trace --field {} --integrator {} --duration {}",
                                 options.field, options.integrator, options.duration);
  for (const auto& [name, text] :
       {std::pair("--seed", &options.seed.seed), std::pair("--seeds", &options.seed.seeds)})
    if (!text->empty()) call += fmt::format(" {} {}", name, *text);
  if (options.start_time != 0) call += fmt::format(" --start-time {}", options.start_time);
  for (const auto& [name, given] :
       {std::pair("--closed", options.seed.closed), std::pair("--path", options.path),
        std::pair("--both", options.both)})
    if (given) call += fmt::format(" {}", name);
  if (!options.carry.empty()) call += fmt::format(" --carry {}", fmt::join(options.carry, " "));
  return call;
}

/// Gives the vertices the attributes, and `json` what they came to.
void carry(const fields::Attributes& attributes, geometry::Vertices& vertices,
           nlohmann::ordered_json& json) {
  integrators::carry(attributes, vertices.positions, vertices);
  for (const std::string& name : attributes.names()) {
    const std::vector<double>& values = vertices.scalars.at(name);
    const Vec2 range = scene::finite_range(values);
    const auto has_none = [](double value) { return std::isnan(value); };
    json["carried"][name] = {{"min", range.x},
                             {"max", range.y},
                             {"without_value", std::ranges::count_if(values, has_none)}};
  }
}

/// Of the surface from that of another integrator, and the other way round.
nlohmann::ordered_json distance_between(const TraceOptions& options,
                                        const geometry::TriangleMesh& mesh,
                                        const geometry::TriangleMesh& other) {
  const auto [from_this, from_other] =
      integrators::mesh_distance(mesh, other, options.error_samples());
  return {{"integrator", options.against},
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
  compare::write_image(file, compare::distance_picture(view, mesh, distances).image,
                       compare::form_of_map("distance from the exact surface, as colours"));
}

/// `integrate(call)` makes a surface, `measure(surface)` tells how far it is from the exact one; in
/// the field `way`, which may be a reversed one.
template <class Integrate, class Measure>
void trace_mesh(const TraceOptions& options, const GlobalOptions& globals,
                const fields::VectorField& way, const fields::Attributes& attributes,
                const Integrate& integrate, const Measure& measure) {
  // The other first: a wrong call is refused before the long work.
  std::optional<geometry::TriangleMesh> other;
  if (!options.against.empty()) other = integrate(options.against).mesh;
  auto surface = integrate(options.integrator);
  nlohmann::ordered_json json =
      compare::surface_json(surface, integrators::measure_quality(surface.mesh));
  const Progress progress = console_progress(globals);
  if (options.error_samples() > 0) {
    report(progress, 1, "measuring the distance to the exact surface");
    integrators::SurfaceError error = measure(surface);
    compare::add_error_json(json, error);
    surface.mesh.scalars["error"] = std::move(error.at_vertices);
  }
  if (other) {
    report(progress, 1, "measuring the distance between the two surfaces");
    json["against"] = distance_between(options, surface.mesh, *other);
  }
  if (!options.error_picture.empty())
    write_error_picture(options.error_picture, surface.mesh, surface.mesh.scalars.at("error"));
  integrators::turn_back(surface.mesh, way);
  carry(attributes, surface.mesh, json);
  json["field"] = way.description();
  geometry::write_mesh(options.output, surface.mesh, origin_of(options));
  print(options, globals, json);
}

void trace_surface(const TraceOptions& options, const GlobalOptions& globals,
                   const fields::VectorField& way, const fields::Attributes& attributes) {
  integrators::SurfaceRequest request;
  request.field = &way;
  request.seed = surface_seed(options.seed);
  request.duration = std::abs(options.duration);
  request.start_time = options.start_time;
  request.path = options.path;
  request.progress = console_progress(globals);
  trace_mesh(
      options, globals, way, attributes,
      [&](const std::string& call) { return integrators::integrate_surface(call, request); },
      [&](const integrators::IntegratedSurface& surface) {
        return integrators::measure_error(surface.mesh, request, options.error_samples(),
                                          integrators::integrator_parameters(options.integrator));
      });
}

void trace_sheet(const TraceOptions& options, const GlobalOptions& globals,
                 const fields::VectorField& way, const fields::Attributes& attributes) {
  integrators::SheetRequest request;
  request.field = &way;
  if (integrators::integrator_kind(options.integrator) == integrators::IntegratorKind::streak_sheet)
    request.curve = surface_seed(options.seed);
  else
    request.surface = sheet_seed(options.seed);
  request.duration = std::abs(options.duration);
  request.start_time = options.start_time;
  request.progress = console_progress(globals);
  trace_mesh(
      options, globals, way, attributes,
      [&](const std::string& call) { return integrators::integrate_sheet(call, request); },
      [&](const integrators::IntegratedSheet& sheet) {
        return integrators::measure_sheet_error(sheet, request, options.error_samples(),
                                                integrators::sheet_parameters(options.integrator));
      });
}

void trace_lines(const TraceOptions& options, const GlobalOptions& globals,
                 const fields::VectorField& field, const fields::Attributes& attributes) {
  integrators::LineRequest request;
  request.field = &field;
  request.seeds = line_seeds(options.seed, options.integrator);
  request.duration = options.duration;
  request.start_time = options.start_time;
  request.both = options.both;
  request.progress = console_progress(globals);
  integrators::IntegratedLines lines = integrators::integrate_lines(options.integrator, request);
  nlohmann::ordered_json json = compare::lines_json(lines);
  carry(attributes, lines.lines, json);
  geometry::write_lines(options.output, lines.lines, origin_of(options));
  json["field"] = field.description();
  print(options, globals, json);
}

/// Throws InputError for numbers that the output's format does not hold.
void check_carried(const TraceOptions& options) {
  const geometry::FormatRow* format = geometry::mesh_format(options.output);
  if (options.carry.empty() || !format || format->writes_scalars) return;
  std::string accepted;
  for (const geometry::FormatRow& row : geometry::mesh_formats())
    if (row.writes_scalars && row.write_lines)
      accepted += fmt::format("{}{}", accepted.empty() ? "" : ", ", row.ending);
  throw InputError(fmt::format("{}: {} files hold no '{}' of --carry; accepted: {}", options.output,
                               format->ending, options.carry.front(), accepted));
}

void trace(const TraceOptions& options, const GlobalOptions& globals) {
  using integrators::IntegratorKind;
  const ProtectedInputs inputs;
  const std::shared_ptr<const fields::VectorField> field = fields::make_field(options.field);
  const IntegratorKind kind = integrators::integrator_kind(options.integrator);
  const bool lines = kind == IntegratorKind::lines;
  if (options.both && !lines)
    throw InputError("--both: accepted: with an integrator of lines; of a surface run each way");
  for (const auto& [name, value] : {std::pair("--error-picture", &options.error_picture),
                                    std::pair("--against", &options.against)})
    if (!value->empty() && (lines || options.error_samples() == 0))
      throw InputError(
          fmt::format("{}: accepted: with a surface and --samples of at least 1", name));
  check_carried(options);
  if (lines && options.samples) throw InputError("--samples: accepted: with a surface");
  const fields::Attributes attributes(options.field, {}, options.carry);
  if (lines) {
    if (options.path) integrators::check_runs_along("--path", options.integrator);
    return trace_lines(options, globals, *field, attributes);
  }
  const auto way = options.duration < 0 ? fields::reversed(field, options.start_time) : field;
  if (integrators::is_sheet(kind))
    trace_sheet(options, globals, *way, attributes);
  else
    trace_surface(options, globals, *way, attributes);
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
                      "each and else joined, or of one polyline. Of a time surface "
                      "patch:corner=X,Y,Z,u=X,Y,Z,v=X,Y,Z, sphere:center=X,Y,Z,radius=R, or a FILE "
                      "of a mesh");
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
  command->add_option("--carry", options->carry,
                      "Arrays of one component of the field's files, NAME... (point:NAME or "
                      "cell:NAME where both have it): scalars of what is written, interpolated as "
                      "the velocity is; NaN where the files have none");
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
      "  pellucid trace --field flow.vtu --integrator stream-lines --duration 2 -o lines.vtp \\\n"
      "      --seed 0,0,0:0,1,0 --carry p T\n"
      "  pellucid trace --field double-gyre --integrator streak-surface:tolerance=0.01 \\\n"
      "      --seed 1,0.2,0:1,0.2,1 --duration 10 -o streak.ply\n"
      "  pellucid trace --field double-gyre --integrator time-surface --duration 10 -o dye.ply \\\n"
      "      --seeds sphere:center=1,0.5,0.5,radius=0.2\n"
      "What may stand behind a file's name: docs/fields.md; formats: pellucid list formats.");
  add_global_options(*command, globals);
  command->callback([options, &globals] { trace(*options, globals); });
}

}  // namespace pellucid::app
