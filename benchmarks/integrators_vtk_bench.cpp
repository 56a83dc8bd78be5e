// SPDX-License-Identifier: GPL-3.0-or-later
// Integral surfaces beside VTK's vtkStreamSurface, on one thread each: beside each of its runs the
// cheapest of ours whose largest distance from the closed form is no larger. The fields are linear,
// so that trilinear samples are exact: both programs integrate the same field from the same image.
#include <benchmark/benchmark.h>
#include <tbb/global_control.h>
#include <vtkCellArray.h>
#include <vtkPolyData.h>
#include <vtkStreamSurface.h>
#include <vtkTriangleFilter.h>

#include <fmt/format.h>

#include <algorithm>
#include <ctime>

#include "benchmarks/field_samples.h"
#include "tests/integrators/closed_forms.h"

namespace {

using namespace pellucid;
using namespace pellucid::benchmarks;
using pellucid::integrators::testing::ClosedForm;

/// Processor time of all threads: the machine may be shared.
double cpu_seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

vtkNew<vtkPolyData> polyline(const integrators::SeedCurve& seed, int count) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(count);
  for (int i = 0; i < count; ++i) {
    const Vec3 x = seed.point_at(double(i) / (count - 1));
    lines->InsertCellPoint(points->InsertNextPoint(x.x, x.y, x.z));
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(lines);
  return data;
}

/// The box that the surface of this form stays in.
Box3 box_of(const ClosedForm& form) {
  Box3 box =
      pellucid::integrators::testing::sweep(form, "hultquist:threshold=0.1").surface.mesh.bounds();
  box.extend(box.min - Vec3(0.1));
  box.extend(box.max + Vec3(0.1));
  return box;
}

geometry::TriangleMesh triangles_of(vtkPolyData* data) {
  geometry::TriangleMesh mesh;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {
    double x[3];
    data->GetPoint(i, x);
    mesh.positions.emplace_back(x[0], x[1], x[2]);
  }
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i) {
    vtkCell* cell = data->GetCell(i);
    if (cell->GetNumberOfPoints() == 3)
      mesh.triangles.push_back({std::uint32_t(cell->GetPointId(0)),
                                std::uint32_t(cell->GetPointId(1)),
                                std::uint32_t(cell->GetPointId(2))});
  }
  return mesh;
}

struct VtkRun {
  bool iterative;
  double spacing;  // of seeds and of steps, world units
};

vtkNew<vtkStreamSurface> vtk_filter(const ClosedForm& form, const VtkRun& run, vtkImageData* image,
                                    double length) {
  vtkNew<vtkStreamSurface> filter;
  filter->SetInputData(0, image);
  filter->SetInputData(1, polyline(form.seed, int(1 / run.spacing) + 1));
  filter->SetIntegratorTypeToRungeKutta4();
  filter->SetIntegrationDirectionToForward();
  filter->SetIntegrationStepUnit(vtkStreamTracer::LENGTH_UNIT);
  filter->SetInitialIntegrationStep(run.spacing);
  filter->SetMaximumPropagation(length);
  filter->SetUseIterativeSeeding(run.iterative);
  return filter;
}

geometry::TriangleMesh mesh_of(vtkStreamSurface* filter) {
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(filter->GetOutput());
  triangles->Update();
  return triangles_of(triangles->GetOutput());
}

/// Processor time: the median of several calls, which take at least a tenth of a second together.
template <class Function>
double median_seconds(const Function& function) {
  std::vector<double> seconds;
  double total = 0;
  while (seconds.size() < 5 || (total < 0.1 && seconds.size() < 99)) {
    const double begin = cpu_seconds();
    function();
    seconds.push_back(cpu_seconds() - begin);
    total += seconds.back();
  }
  std::sort(seconds.begin(), seconds.end());
  return seconds[seconds.size() / 2];
}

/// The loosest tolerance, of a ladder, at which our error is at most VTK's.
std::string as_exact_as(const integrators::SurfaceRequest& request, const ClosedForm& form,
                        double error) {
  for (double tolerance = 4 * error;; tolerance *= 0.9) {
    const std::string integrator = fmt::format("hultquist:tolerance={}", tolerance);
    const geometry::TriangleMesh mesh = integrators::integrate_surface(integrator, request).mesh;
    if (pellucid::integrators::testing::largest_distance(form, mesh) <= error) return integrator;
  }
}

/// VTK's time over ours at equal largest error, both from the same image, one thread each. Ours has
/// normals, VTK's has none.
void beside_vtk(benchmark::State& state, const ClosedForm& form, const VtkRun& run) {
  const auto formula = fields::make_field(form.field);
  const Box3 box = box_of(form);
  const auto image = samples_of(*formula, box, 32);
  const auto field = sampled(*formula, box, 32);
  const double length = pellucid::integrators::testing::sweep(form, "hultquist:threshold=0.1")
                            .surface.mesh.bounds()
                            .diagonal();
  const integrators::SurfaceRequest request{field.get(), form.seed, form.duration, 0, false, {}};
  for (auto _ : state) {
    const auto filter = vtk_filter(form, run, image, length);
    filter->Update();
    const geometry::TriangleMesh theirs = mesh_of(filter);
    const double error = pellucid::integrators::testing::largest_distance(form, theirs);
    const std::string integrator = as_exact_as(request, form, error);
    const geometry::TriangleMesh ours = integrators::integrate_surface(integrator, request).mesh;
    const double vtk_seconds =
        median_seconds([&] { vtk_filter(form, run, image, length)->Update(); });
    const double our_seconds =
        median_seconds([&] { integrators::integrate_surface(integrator, request); });
    state.counters["vtk_ms"] = 1e3 * vtk_seconds;
    state.counters["vtk_error"] = error;
    state.counters["vtk_triangles"] = double(theirs.triangles.size());
    state.counters["our_ms"] = 1e3 * our_seconds;
    state.counters["our_error"] = pellucid::integrators::testing::largest_distance(form, ours);
    state.counters["our_triangles"] = double(ours.triangles.size());
    state.counters["times_as_fast"] = vtk_seconds / our_seconds;
  }
}

void add_side_by_side() {
  for (const ClosedForm& form : pellucid::integrators::testing::closed_forms()) {
    if (form.name != "Helicoid" && form.name != "HalfSaddle") continue;
    for (const double spacing : {0.08, 0.04, 0.02, 0.01})
      for (const bool iterative : {true, false})
        benchmark::RegisterBenchmark(fmt::format("{}/beside vtk {}/spacing={}", form.name,
                                                 iterative ? "iterative" : "simple", spacing)
                                         .c_str(),
                                     beside_vtk, form, VtkRun{iterative, spacing})
            ->Iterations(1)
            ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  add_side_by_side();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
