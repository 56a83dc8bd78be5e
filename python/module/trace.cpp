// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "compare/results/surface_json.h"
#include "core/error.h"
#include "fields/make_field.h"
#include "fields/readers/attributes.h"
#include "fields/reversed_field.h"
#include "integrators/integrator_kind.h"
#include "integrators/paths/backward.h"
#include "integrators/paths/carried.h"
#include "integrators/sheets/integrate_sheet.h"
#include "integrators/sheets/sheet_error.h"
#include "integrators/surfaces/integrate_surface.h"
#include "module/module.h"
#include "module/shapes.h"
#include "module/values.h"
#include "module/work.h"

namespace pellucid::python {
namespace {

struct Request {
  std::string field, integrator;
  std::vector<Vec3> seed;
  double duration = 0, start_time = 0;
  bool closed = false, path = false;
  long long samples = 0;
  std::vector<std::string> carry;
};

void carry(const Request& request, geometry::Vertices& vertices) {
  integrators::carry(fields::Attributes(request.field, {}, request.carry), vertices.positions,
                     vertices);
}

/// The mesh as it is handed over, with what is known of it.
Surface surface_of(const Request& request, integrators::IntegratedSurface made,
                   const fields::VectorField& way, std::optional<integrators::SurfaceError> error) {
  auto quality = compare::surface_json(made, integrators::measure_quality(made.mesh));
  if (error) {
    compare::add_error_json(quality, *error);
    made.mesh.scalars["error"] = std::move(error->at_vertices);
  }
  integrators::turn_back(made.mesh, way);
  carry(request, made.mesh);
  auto surface = shape_of<Surface>(std::move(made.mesh));
  surface.quality = std::move(quality);
  return surface;
}

Surface trace_surface(const Request& request, const fields::VectorField& way,
                      const Progress& progress) {
  const integrators::SurfaceRequest wanted{&way,
                                           integrators::polyline_seed(request.seed, request.closed),
                                           std::abs(request.duration),
                                           request.start_time,
                                           request.path,
                                           progress};
  integrators::IntegratedSurface made = integrators::integrate_surface(request.integrator, wanted);
  std::optional<integrators::SurfaceError> error;
  if (request.samples > 0)
    error = integrators::measure_error(made.mesh, wanted, std::uint64_t(request.samples),
                                       integrators::integrator_parameters(request.integrator));
  return surface_of(request, std::move(made), way, std::move(error));
}

/// The seed of a time surface: a parallelogram's corner and the ends of its two sides there.
integrators::SeedSurface patch_of(const std::vector<Vec3>& points) {
  if (points.size() != 3)
    throw InputError(
        fmt::format("trace: seed: {} points; accepted of a time surface: three, the corner of a "
                    "parallelogram and the ends of its two sides there",
                    points.size()));
  return integrators::patch_seed(points[0], points[1] - points[0], points[2] - points[0]);
}

Surface trace_sheet(const Request& request, const fields::VectorField& way, bool of_curve,
                    const Progress& progress) {
  integrators::SheetRequest wanted;
  wanted.field = &way;
  if (of_curve)
    wanted.curve = integrators::polyline_seed(request.seed, request.closed);
  else
    wanted.surface = patch_of(request.seed);
  wanted.duration = std::abs(request.duration);
  wanted.start_time = request.start_time;
  wanted.progress = progress;
  integrators::IntegratedSheet made = integrators::integrate_sheet(request.integrator, wanted);
  std::optional<integrators::SurfaceError> error;
  if (request.samples > 0)
    error = integrators::measure_sheet_error(made, wanted, std::uint64_t(request.samples),
                                             integrators::sheet_parameters(request.integrator));
  return surface_of(request, std::move(made), way, std::move(error));
}

Surface trace_mesh(const Request& request, integrators::IntegratorKind kind,
                   const Progress& progress) {
  using integrators::IntegratorKind;
  const std::shared_ptr<const fields::VectorField> field = fields::make_field(request.field);
  const auto way = request.duration < 0 ? fields::reversed(field, request.start_time) : field;
  if (!integrators::is_sheet(kind)) return trace_surface(request, *way, progress);
  return trace_sheet(request, *way, kind == IntegratorKind::streak_sheet, progress);
}

Lines trace_lines(const Request& request, const fields::VectorField& field,
                  const Progress& progress) {
  integrators::LineRequest wanted{&field, request.seed, request.duration, request.start_time,
                                  progress};
  if (wanted.seeds.size() > 1)
    wanted.seeds = integrators::seeds_on(integrators::polyline_seed(request.seed, request.closed),
                                         integrators::line_particles(request.integrator));
  else
    integrators::check_seeds_are_points(request.integrator);
  integrators::IntegratedLines made = integrators::integrate_lines(request.integrator, wanted);
  auto stats = compare::lines_json(made);
  carry(request, made.lines);
  auto lines = shape_of<Lines>(std::move(made.lines));
  lines.stats = std::move(stats);
  return lines;
}

py::object trace(const py::object& field, const py::object& integrator, const py::object& seed,
                 const py::object& duration, bool closed, const py::object& start_time, bool path,
                 const py::object& samples, const py::object& carry) {
  const Request request{path_of(field, "trace: field"),
                        text_of(integrator, "trace: integrator"),
                        vectors_of(seed, "trace: seed"),
                        number_of(duration, "trace: duration"),
                        number_of(start_time, "trace: start_time"),
                        closed,
                        path,
                        integer_of(samples, "trace: samples"),
                        texts_of(carry, "trace: carry")};
  if (request.seed.empty()) throw InputError("trace: seed: no point; accepted: at least one");
  if (request.samples < 0 || std::uint64_t(request.samples) > integrators::most_error_samples)
    throw InputError(fmt::format("trace: samples: {}; accepted: 0 … {}", request.samples,
                                 integrators::most_error_samples));
  const integrators::IntegratorKind kind = integrators::integrator_kind(request.integrator);
  if (kind != integrators::IntegratorKind::lines)
    return py::cast(result_unlocked(
        [&](const Progress& progress) { return trace_mesh(request, kind, progress); }));
  if (request.path) integrators::check_runs_along("trace: path", request.integrator);
  if (request.samples > 0) throw InputError("trace: samples: accepted: of a surface");
  return py::cast(result_unlocked([&](const Progress& progress) {
    return trace_lines(request, *fields::make_field(request.field), progress);
  }));
}

constexpr const char* trace_doc = R"(Integrates a surface, or lines, from a seed.

field: a name such as 'abc', a formula 'formula:u=-y,v=x,w=0.2', or a file (`pellucid list fields`).
integrator: such as 'hultquist:particles=20' (`pellucid list integrators`).
seed: (N, 3), a polyline in world units; closed joins its ends. Of 'time-surface' (3, 3): the corner of a
parallelogram and the ends of its two sides there. duration: in the field's units of time;
below 0 particles go the way back.
path: a path surface of an unsteady field, from start_time on. samples: points at which the distance to
the exact surface is measured, world units; it is then the scalar 'error'. carry: names of arrays of one
component of the field's files, such as ['p', 'T']: further scalars, interpolated as the velocity is, NaN
where the files have none.
Returns a Surface; Lines for an integrator of lines. Raises InputError.)";

}  // namespace

void define_trace(py::module_& module) {
  module.def("trace", trace, py::arg("field"), py::arg("integrator"), py::arg("seed"),
             py::arg("duration"), py::kw_only(), py::arg("closed") = false,
             py::arg("start_time") = 0.0, py::arg("path") = false, py::arg("samples") = 0,
             py::arg("carry") = py::tuple(), trace_doc);
}

}  // namespace pellucid::python
