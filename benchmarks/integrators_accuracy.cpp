// SPDX-License-Identifier: GPL-3.0-or-later
// How accurate the integrators are, number by number, as docs/integrators.md lists them: each row
// prints what was measured. The tests hold the same closed forms to bounds.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>

#include "core/options/names.h"
#include "integrators/mesh/mesh_quality.h"
#include "integrators/paths/counting_sampler.h"
#include "integrators/paths/trajectory.h"
#include "integrators/surfaces/surface_error.h"
#include "tests/integrators/closed_forms.h"

namespace {

using namespace pellucid;
using pellucid::integrators::testing::closed_forms;
using pellucid::integrators::testing::ClosedForm;
using pellucid::integrators::testing::sweep;

// The end points are in error by less than 1e-15.
const Vec3 abc_start(0.1, 0.2, 0.3);
const Vec3 abc_end_1(1.887611046492209, 1.911433906176317, 1.728439620240521);
const Vec3 abc_end_10(-4.100131563534621, 1.161312073414934, -2.922645438554284);

struct Arrival {
  double error;
  std::uint64_t evaluations;
};

Arrival arrive(const integrators::TrajectoryOptions& options, const Vec3& end) {
  const auto field = fields::make_field("abc");
  integrators::CountingSampler sampler(*field);
  integrators::Trajectory path(options, abc_start, Vec3(0), sampler);
  path.reach(options.duration, sampler);
  return {glm::distance(path.at(options.duration).x, end), sampler.evaluations()};
}

void stepper_order(benchmark::State& state, const integrators::ButcherTableau& row) {
  integrators::TrajectoryOptions options;
  options.stepper = &row;
  options.tolerance = 1e300;  // every step is accepted: steps of one size
  const auto error = [&](double step) {
    options.max_step = step;
    return arrive(options, abc_end_1).error;
  };
  const double h = row.order == 1 ? 1. / 512 : row.order == 4 ? 1. / 32 : 1. / 16;
  for (auto _ : state) state.counters["order"] = std::log2(error(h) / error(h / 2));
}

void dopri5_on_abc(benchmark::State& state) {
  integrators::TrajectoryOptions options;
  options.stepper = &find_row("stepper", "dopri5", integrators::steppers());
  options.duration = 10;
  options.tolerance = 1e-8;
  for (auto _ : state) {
    const auto [error, evaluations] = arrive(options, abc_end_10);
    state.counters["error"] = error;
    state.counters["evaluations"] = double(evaluations);
  }
}

struct FrontError {
  double distance, facet_mean, facet_max;
};

/// Over all triangles.
FrontError fixed_front_error(const ClosedForm& form, int n) {
  const auto swept = sweep(form, fmt::format("fixed-front:particles={},rows={}", n + 1, 3 * n / 2));
  const integrators::SurfaceError error =
      integrators::measure_error(swept.surface.mesh, swept.request, 1 << 20);
  return {integrators::testing::largest_distance(form, swept.surface.mesh),
          error.normal_mean_degrees, integrators::testing::worst_facet(form, swept.surface.mesh)};
}

void surface_order(benchmark::State& state, const ClosedForm& form) {
  const auto n = int(state.range(0));
  for (auto _ : state) {
    const FrontError coarse = fixed_front_error(form, n), fine = fixed_front_error(form, 2 * n);
    const auto order = [](double a, double b) { return std::log2(a / b); };
    state.counters["position"] = order(coarse.distance, fine.distance);
    state.counters["facet_mean"] = order(coarse.facet_mean, fine.facet_mean);
    state.counters["facet_max"] = order(coarse.facet_max, fine.facet_max);
    state.counters["worst_facet_degrees"] = fine.facet_max;
  }
}

/// The largest error and facet angle at a tolerance.
void tolerance_held(benchmark::State& state, const ClosedForm& form, std::string_view integrator,
                    double tolerance) {
  for (auto _ : state) {
    const auto swept =
        sweep(form, fmt::format("{}:particles=2,tolerance={}", integrator, tolerance));
    const geometry::TriangleMesh& mesh = swept.surface.mesh;
    state.counters["error/tolerance"] =
        integrators::testing::largest_distance(form, mesh) / tolerance;
    state.counters["worst_facet_degrees"] = integrators::testing::worst_facet(form, mesh);
    state.counters["triangles"] = double(mesh.triangles.size());
    double off = 0;
    for (const Vec3& x : mesh.positions)
      off = std::max(off, integrators::testing::implicit_distance(form, x));
    state.counters["vertices_off"] = off;
  }
}

/// The worst facets of meshes by tolerances that are quarters of each other: their edges halve.
void facet_tilt(benchmark::State& state, const ClosedForm& form, std::string_view integrator) {
  for (auto _ : state)
    for (const double tolerance : {1.6e-2, 4e-3, 1e-3, 2.5e-4, 6.25e-5, 1.5625e-5}) {
      const auto swept = sweep(
          form, fmt::format("{}:particles=2,tolerance={},facet-angle=180", integrator, tolerance));
      state.counters[fmt::format("{:.3g}", tolerance)] =
          integrators::testing::worst_facet(form, swept.surface.mesh);
    }
}

/// Facets of the ABC surface, whose front leans along the flow, against the vertices' own normals,
/// all of them; and against the exact surface, a sample.
void abc_facets(benchmark::State& state, const std::string& integrator) {
  const auto field = fields::make_field("abc");
  const integrators::SurfaceRequest request{
      field.get(), integrators::segment_seed({3.1, 3.1, 0.1}, {3.1, 3.1, 6.1}), 9, 0, false, {}};
  for (auto _ : state) {
    const integrators::IntegratedSurface surface =
        integrators::integrate_surface(integrator, request);
    const integrators::MeshQuality quality = integrators::measure_quality(surface.mesh);
    state.counters["worst_degrees"] = quality.normal_degrees.max;
    state.counters["p99_degrees"] = quality.normal_degrees.p99;
    state.counters["sampled_degrees"] =
        integrators::measure_error(surface.mesh, request, 4000).normal_max_degrees;
    state.counters["triangles"] = double(surface.mesh.triangles.size());
    state.counters["particles"] = double(surface.stats.particles);
    state.counters["vertex_particles"] =
        surface.stats.ends.contains(integrators::EndReason::vertex)
            ? double(surface.stats.ends.at(integrators::EndReason::vertex))
            : 0;
    state.counters["trimmed"] = double(surface.stats.trimmed);
    state.counters["degenerate"] = double(quality.degenerate_triangles);
    state.counters["seconds"] = surface.stats.seconds;
  }
}

void crossing_saddle(benchmark::State& state) {
  const ClosedForm form{"", "saddle", integrators::testing::wave_seed(-1, 1, 0.2, 3),
                        5,  false,    integrators::testing::wave};
  for (auto _ : state) {
    const auto swept = sweep(form, "hultquist:tolerance=1e-2");
    state.counters["sheets"] = double(integrators::measure_quality(swept.surface.mesh).sheets);
    state.counters["particles"] = double(swept.surface.stats.particles);
  }
}

template <class Function, class... Arguments>
auto* add(const std::string& name, Function function, Arguments... arguments) {
  return benchmark::RegisterBenchmark(name.c_str(), function, arguments...)
      ->Iterations(1)
      ->Unit(benchmark::kMillisecond);
}

}  // namespace

int main(int argc, char** argv) {
  for (const integrators::ButcherTableau& row : integrators::steppers())
    add(fmt::format("order/{}", row.name), stepper_order, row);
  add("abc, T=10/dopri5 at 1e-8", dopri5_on_abc);
  for (const ClosedForm& form : closed_forms())
    add("order of the surface/" + form.name, surface_order, form)->Arg(16)->Arg(32)->Arg(64);
  for (const ClosedForm& form : closed_forms())
    for (const integrators::IntegratorRow& row : integrators::integrators())
      for (const double tolerance : {1e-2, 1e-3, 1e-4})
        if (row.promises.bounds_error)
          add(fmt::format("tolerance/{}/{}/{}", form.name, row.name, tolerance), tolerance_held,
              form, row.name, tolerance);
  for (const ClosedForm& form : closed_forms())
    for (const integrators::IntegratorRow& row : integrators::integrators())
      if (row.promises.bounds_error)
        add(fmt::format("facet tilt/{}/{}", form.name, row.name), facet_tilt, form, row.name);
  for (const char* integrator :
       {"hultquist:threshold=0.05", "hultquist:tolerance=0.002", "adaptive-front:tolerance=0.002",
        "adaptive-front:particles=500,threshold=0.5"})
    for (const char* rest : {",facet-angle=180", "", ",rip=1e-8,facet-angle=180", ",rip=1e-8"})
      add(fmt::format("abc facets, T=9/{}{}", integrator, rest), abc_facets,
          std::string(integrator) + rest);
  add("half saddle in 50000 triangles", tolerance_held, closed_forms()[1], "hultquist", 5e-5);
  add("crossing saddle, T=5", crossing_saddle);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
