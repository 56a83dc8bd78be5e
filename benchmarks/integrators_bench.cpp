// SPDX-License-Identifier: GPL-3.0-or-later
// Integral surfaces, on one thread:
// - triangles per second of processor time, and that time against the field evaluations' alone: the
//   very places that a run asks for are recorded, and asked for once more in the same order;
// - VTK's vtkStreamSurface, and beside each of its runs the cheapest of ours whose largest distance
//   from the closed form is no larger. The fields are linear, so that trilinear samples are exact:
//   both programs integrate the same field from the same image.
#include <benchmark/benchmark.h>
#include <tbb/global_control.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStreamSurface.h>
#include <vtkTriangleFilter.h>
#include <vtkXMLImageDataWriter.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <filesystem>

#include "integrators/lines/integrate_lines.h"
#include "tests/integrators/closed_forms.h"

namespace {

using namespace pellucid;
using pellucid::testing::ClosedForm;

/// Processor time of all threads: the machine may be shared.
double cpu_seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

struct Request {
  Vec3 x;
  double t;
  bool jacobian;
};

/// A field that writes down what it is asked; for one thread.
class RecordedField final : public fields::VectorField {
 public:
  explicit RecordedField(const fields::VectorField& field) : field_(field) {}

  std::unique_ptr<fields::FieldSampler> sampler() const override {
    return std::make_unique<Sampler>(field_.sampler(), requests_);
  }
  Box3 domain() const override { return field_.domain(); }
  bool steady() const override { return field_.steady(); }
  std::optional<double> cell_size() const override { return field_.cell_size(); }
  std::optional<double> sampling_error() const override { return field_.sampling_error(); }
  bool fills_domain() const override { return field_.fills_domain(); }
  std::string description() const override { return field_.description(); }

  const std::vector<Request>& requests() const { return requests_; }

 private:
  class Sampler final : public fields::FieldSampler {
   public:
    Sampler(std::unique_ptr<fields::FieldSampler> sampler, std::vector<Request>& requests)
        : sampler_(std::move(sampler)), requests_(requests) {}
    fields::SampleStatus velocity(const Vec3& x, double t, Vec3& v) override {
      requests_.push_back({x, t, false});
      return sampler_->velocity(x, t, v);
    }
    fields::SampleStatus velocity_and_jacobian(const Vec3& x, double t, Vec3& v,
                                               Mat3& jacobian) override {
      requests_.push_back({x, t, true});
      return sampler_->velocity_and_jacobian(x, t, v, jacobian);
    }

   private:
    std::unique_ptr<fields::FieldSampler> sampler_;
    std::vector<Request>& requests_;
  };

  const fields::VectorField& field_;
  mutable std::vector<Request> requests_;
};

/// Processor time of the field evaluations of a run by themselves: the median of five.
double evaluation_seconds(const fields::VectorField& field, const std::vector<Request>& requests) {
  const auto sampler = field.sampler();
  std::array<double, 5> seconds;
  for (double& each : seconds) {
    const double begin = cpu_seconds();
    for (const Request& request : requests) {
      Vec3 v;
      Mat3 jacobian;
      if (request.jacobian)
        sampler->velocity_and_jacobian(request.x, request.t, v, jacobian);
      else
        sampler->velocity(request.x, request.t, v);
      benchmark::DoNotOptimize(v);
      benchmark::DoNotOptimize(jacobian);
    }
    each = cpu_seconds() - begin;
  }
  std::sort(seconds.begin(), seconds.end());
  return seconds[seconds.size() / 2];
}

void report_surface(benchmark::State& state, const integrators::IntegratedSurface& surface,
                    double evaluation_seconds, double seconds) {
  const double triangles = double(surface.mesh.triangles.size());
  const double each = seconds / double(state.iterations());
  state.counters["triangles"] = triangles;
  state.counters["evaluations"] = double(surface.stats.evaluations);
  state.counters["triangles/s"] = triangles / each;
  state.counters["time/evaluations"] = each / evaluation_seconds;
  state.counters["mesh_ns/triangle"] = 1e9 * (each - evaluation_seconds) / triangles;
}

/// Runs it again and again, and once more to see what its field evaluations take by themselves.
integrators::IntegratedSurface time_surface(benchmark::State& state,
                                            integrators::SurfaceRequest request,
                                            const std::string& integrator) {
  integrators::IntegratedSurface surface;
  const double begin = cpu_seconds();
  for (auto _ : state) surface = integrators::integrate_surface(integrator, request);
  const double seconds = cpu_seconds() - begin;
  const fields::VectorField& field = *request.field;
  const RecordedField recorded(field);
  request.field = &recorded;
  integrators::integrate_surface(integrator, request);
  report_surface(state, surface, evaluation_seconds(field, recorded.requests()), seconds);
  return surface;
}

void abc_lines(benchmark::State& state) {
  const auto field = fields::make_field("abc");
  integrators::LineRequest request;
  request.field = field.get();
  request.seeds =
      integrators::seeds_on(integrators::segment_seed({2.64, 3.14, 3.14}, {3.64, 3.14, 3.14}), 65);
  request.duration = 12;
  std::size_t vertices = 0;
  for (auto _ : state)
    vertices =
        integrators::integrate_lines("stream-lines:step=0.05", request).lines.positions.size();
  state.counters["vertices"] = double(vertices);
}

vtkNew<vtkImageData> samples_of(const fields::VectorField& field, const Box3& box, int n) {
  vtkNew<vtkImageData> image;
  image->SetDimensions(n, n, n);
  image->SetOrigin(box.min.x, box.min.y, box.min.z);
  const Vec3 size = box.max - box.min;
  image->SetSpacing(size.x / (n - 1), size.y / (n - 1), size.z / (n - 1));
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("velocity");
  vectors->SetNumberOfComponents(3);
  const auto sampler = field.sampler();
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i) {
    double x[3];
    image->GetPoint(i, x);
    Vec3 v;
    sampler->velocity({x[0], x[1], x[2]}, 0, v);
    vectors->InsertNextTuple3(v.x, v.y, v.z);
  }
  image->GetPointData()->SetVectors(vectors);
  return image;
}

/// The field's samples at n³ points of the box, trilinear between them.
std::unique_ptr<fields::VectorField> sampled(const fields::VectorField& field, const Box3& box,
                                             int n) {
  const auto path = std::filesystem::temp_directory_path() / "pellucid_bench.vti";
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(samples_of(field, box, n));
  writer->Write();
  auto samples = fields::make_field(path.string());
  std::filesystem::remove(path);
  return samples;
}

/// The same surface of the same flow by three kinds of field whose evaluations cost differently.
std::unique_ptr<fields::VectorField> abc_field(const std::string& kind) {
  if (kind == "formula")
    return fields::make_field(
        "formula:u=sqrt(3)*sin(z)+cos(y),v=sqrt(2)*sin(x)+sqrt(3)*cos(z),w=sin(y)+sqrt(2)*cos(x)");
  auto abc = fields::make_field("abc");
  return kind == "samples" ? sampled(*abc, {Vec3(1, -14, 0), Vec3(9, 4, 6)}, 128) : std::move(abc);
}

void abc_surface(benchmark::State& state, const std::string& kind, const std::string& integrator) {
  const auto field = abc_field(kind);
  const Vec3 seed(2.64, 3.14, 3.14);
  time_surface(
      state, {field.get(), integrators::segment_seed(seed, seed + Vec3(1, 0, 0)), 7, 0, false, {}},
      integrator);
}

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
  Box3 box = pellucid::testing::sweep(form, "hultquist:threshold=0.1").surface.mesh.bounds();
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
    if (pellucid::testing::largest_distance(form, mesh) <= error) return integrator;
  }
}

/// VTK's time over ours at equal largest error, both from the same image, one thread each. Ours has
/// normals, VTK's has none.
void beside_vtk(benchmark::State& state, const ClosedForm& form, const VtkRun& run) {
  const auto formula = fields::make_field(form.field);
  const Box3 box = box_of(form);
  const auto image = samples_of(*formula, box, 32);
  const auto field = sampled(*formula, box, 32);
  const double length =
      pellucid::testing::sweep(form, "hultquist:threshold=0.1").surface.mesh.bounds().diagonal();
  const integrators::SurfaceRequest request{field.get(), form.seed, form.duration, 0, false, {}};
  for (auto _ : state) {
    const auto filter = vtk_filter(form, run, image, length);
    filter->Update();
    const geometry::TriangleMesh theirs = mesh_of(filter);
    const double error = pellucid::testing::largest_distance(form, theirs);
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
    state.counters["our_error"] = pellucid::testing::largest_distance(form, ours);
    state.counters["our_triangles"] = double(ours.triangles.size());
    state.counters["times_as_fast"] = vtk_seconds / our_seconds;
  }
}

template <class Function, class... Arguments>
void add(const std::string& name, Function function, Arguments... arguments) {
  benchmark::RegisterBenchmark(name.c_str(), function, arguments...)
      ->MeasureProcessCPUTime()
      ->Unit(benchmark::kMillisecond);
}

void add_side_by_side() {
  for (const ClosedForm& form : pellucid::testing::closed_forms()) {
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
  for (const char* integrator : {"hultquist:threshold=0.05", "hultquist:threshold=0.01",
                                 "hultquist:tolerance=1e-4", "fixed-front:particles=1000,rows=400",
                                 "adaptive-front:threshold=0.05", "adaptive-front:tolerance=1e-3"})
    add(fmt::format("abc/closed form/{}", integrator), abc_surface, std::string("closed form"),
        std::string(integrator));
  for (const char* kind : {"samples", "formula"})
    add(fmt::format("abc/{}/hultquist:tolerance=1e-3", kind), abc_surface, std::string(kind),
        std::string("hultquist:tolerance=1e-3"));
  add("abc/65 stream lines of length 12", abc_lines);
  add_side_by_side();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
