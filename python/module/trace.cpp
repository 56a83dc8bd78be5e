// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/results/surface_json.h"
#include "core/error.h"
#include "core/options/names.h"
#include "fields/make_field.h"
#include "fields/reversed_field.h"
#include "integrators/paths/backward.h"
#include "integrators/surfaces/integrate_surface.h"
#include "module/module.h"
#include "module/shapes.h"
#include "module/values.h"
#include "module/work.h"

namespace pellucid::python {
namespace {

/// Says whether the integrator is one of lines. Throws InputError that lists those of both kinds.
bool draws_lines(std::string_view integrator) {
  const std::string name = parse_name_and_options(integrator).name;
  std::vector<std::string_view> known;
  for (const auto& row : integrators::integrators()) known.push_back(row.name);
  const auto lines = std::ptrdiff_t(known.size());
  for (const auto& row : integrators::line_integrators()) known.push_back(row.name);
  const auto found = std::ranges::find(known, name);
  if (found == known.end()) throw InputError(unknown_name("integrator", name, known));
  return found - known.begin() >= lines;
}

struct Request {
  std::string field, integrator;
  std::vector<Vec3> seed;
  double duration = 0, start_time = 0;
  bool closed = false, path = false;
  long long samples = 0;
};

Surface trace_surface(const Request& request,
                      const std::shared_ptr<const fields::VectorField>& field,
                      const Progress& progress) {
  const auto way = request.duration < 0 ? fields::reversed(field, request.start_time) : field;
  const integrators::SurfaceRequest wanted{way.get(),
                                           integrators::polyline_seed(request.seed, request.closed),
                                           std::abs(request.duration),
                                           request.start_time,
                                           request.path,
                                           progress};
  integrators::IntegratedSurface made = integrators::integrate_surface(request.integrator, wanted);
  auto quality = compare::surface_json(made, integrators::measure_quality(made.mesh));
  if (request.samples > 0) {
    integrators::SurfaceError error =
        integrators::measure_error(made.mesh, wanted, std::uint64_t(request.samples),
                                   integrators::integrator_parameters(request.integrator));
    compare::add_error_json(quality, error);
    made.mesh.scalars["error"] = std::move(error.at_vertices);
  }
  integrators::turn_back(made.mesh, *way);
  auto surface = shape_of<Surface>(std::move(made.mesh));
  surface.quality = std::move(quality);
  return surface;
}

Lines trace_lines(const Request& request, const fields::VectorField& field,
                  const Progress& progress) {
  integrators::LineRequest wanted{&field, request.seed, request.duration, request.start_time,
                                  progress};
  if (wanted.seeds.size() > 1)
    wanted.seeds = integrators::seeds_on(integrators::polyline_seed(request.seed, request.closed),
                                         integrators::line_particles(request.integrator));
  integrators::IntegratedLines made = integrators::integrate_lines(request.integrator, wanted);
  auto stats = compare::lines_json(made);
  auto lines = shape_of<Lines>(std::move(made.lines));
  lines.stats = std::move(stats);
  return lines;
}

py::object trace(const py::object& field, const py::object& integrator, const py::object& seed,
                 const py::object& duration, bool closed, const py::object& start_time, bool path,
                 const py::object& samples) {
  const Request request{path_of(field, "trace: field"),
                        text_of(integrator, "trace: integrator"),
                        vectors_of(seed, "trace: seed"),
                        number_of(duration, "trace: duration"),
                        number_of(start_time, "trace: start_time"),
                        closed,
                        path,
                        integer_of(samples, "trace: samples")};
  if (request.seed.empty()) throw InputError("trace: seed: no point; accepted: at least one");
  if (request.samples < 0 || std::uint64_t(request.samples) > integrators::most_error_samples)
    throw InputError(fmt::format("trace: samples: {}; accepted: 0 … {}", request.samples,
                                 integrators::most_error_samples));
  if (draws_lines(request.integrator) && request.path)
    integrators::check_runs_along("trace: path", request.integrator);
  if (draws_lines(request.integrator))
    return py::cast(result_unlocked([&](const Progress& progress) {
      return trace_lines(request, *fields::make_field(request.field), progress);
    }));
  return py::cast(result_unlocked([&](const Progress& progress) {
    return trace_surface(request, fields::make_field(request.field), progress);
  }));
}

constexpr const char* trace_doc = R"(Integrates a surface, or lines, from a seed.

field: a name such as 'abc', a formula 'formula:u=-y,v=x,w=0.2', or a file (`pellucid list fields`).
integrator: such as 'hultquist:particles=20' (`pellucid list integrators`).
seed: (N, 3), a polyline in world units; closed joins its ends. duration: in the field's units of time;
below 0 particles go the way back.
path: a path surface of an unsteady field, from start_time on. samples: points at which the distance to
the exact surface is measured, world units; it is then the scalar 'error'.
Returns a Surface; Lines for an integrator of lines. Raises InputError.)";

}  // namespace

void define_trace(py::module_& module) {
  module.def("trace", trace, py::arg("field"), py::arg("integrator"), py::arg("seed"),
             py::arg("duration"), py::kw_only(), py::arg("closed") = false,
             py::arg("start_time") = 0.0, py::arg("path") = false, py::arg("samples") = 0,
             trace_doc);
}

}  // namespace pellucid::python
