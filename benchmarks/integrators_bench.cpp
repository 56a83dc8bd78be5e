// Integral surfaces: triangles per second of processor time, that time against that of the field
// evaluations alone, and VTK's vtkStreamSurface on the same data at several resolutions with the
// largest distance from the closed form ("max_error") beside the time. The fields are linear, so
// that trilinear samples are exact: both programs integrate the same field.
#include <benchmark/benchmark.h>
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

#include <ctime>
#include <filesystem>

#include "integrators/integrate_lines.h"
#include "tests/integrators/closed_forms.h"

namespace {

using namespace pellucid;
using pellucid::testing::ClosedForm;

/// Processor time of all threads: the machine may be shared.
double cpu_seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

/// Seconds per evaluation of the field with its Jacobian, at places along its own stream lines.
double seconds_per_evaluation(const VectorField& field, const Vec3& seed) {
  constexpr int count = 200000;
  const auto sampler = field.sampler();
  Vec3 x = seed, v;
  Mat3 jacobian;
  const double begin = cpu_seconds();
  for (int i = 0; i < count; ++i) {
    sampler->velocity_and_jacobian(x, 0, v, jacobian);
    x = seed + 1e-6 * double(i % 1000) * v;
    benchmark::DoNotOptimize(jacobian);
  }
  return (cpu_seconds() - begin) / count;
}

void report_surface(benchmark::State& state, const IntegratedSurface& surface,
                    double evaluation_seconds, double seconds) {
  const double triangles = double(surface.mesh.triangles.size());
  state.counters["triangles"] = triangles;
  state.counters["evaluations"] = double(surface.stats.evaluations);
  state.counters["triangles/s"] =
      benchmark::Counter(triangles * double(state.iterations()), benchmark::Counter::kIsRate);
  state.counters["time/evaluations"] = seconds / double(state.iterations()) /
                                       (double(surface.stats.evaluations) * evaluation_seconds);
}

void abc_lines(benchmark::State& state) {
  const auto field = make_field("abc");
  LineRequest request;
  request.field = field.get();
  request.seeds = seeds_on(segment_seed({2.64, 3.14, 3.14}, {3.64, 3.14, 3.14}), 65);
  request.duration = 12;
  std::size_t vertices = 0;
  for (auto _ : state)
    vertices = integrate_lines("stream-lines:step=0.05", request).lines.positions.size();
  state.counters["vertices"] = double(vertices);
}

vtkNew<vtkImageData> samples_of(const VectorField& field, const Box3& box, int n) {
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
std::unique_ptr<VectorField> sampled(const VectorField& field, const Box3& box, int n) {
  const auto path = std::filesystem::temp_directory_path() / "pellucid_bench.vti";
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(samples_of(field, box, n));
  writer->Write();
  auto samples = make_field(path.string());
  std::filesystem::remove(path);
  return samples;
}

/// The same surface of the same flow by three kinds of field whose evaluations cost differently.
std::unique_ptr<VectorField> abc_field(const std::string& kind) {
  if (kind == "formula")
    return make_field(
        "formula:u=sqrt(3)*sin(z)+cos(y),v=sqrt(2)*sin(x)+sqrt(3)*cos(z),w=sin(y)+sqrt(2)*cos(x)");
  auto abc = make_field("abc");
  return kind == "samples" ? sampled(*abc, {Vec3(1, -14, 0), Vec3(9, 4, 6)}, 128) : std::move(abc);
}

void abc_surface(benchmark::State& state, const std::string& kind, const std::string& integrator) {
  const auto field = abc_field(kind);
  const Vec3 seed(2.64, 3.14, 3.14);
  const SurfaceRequest request{field.get(), segment_seed(seed, seed + Vec3(1, 0, 0)), 7, 0, false,
                               {}};
  IntegratedSurface surface;
  const double begin = cpu_seconds();
  for (auto _ : state) surface = integrate_surface(integrator, request);
  const double seconds = cpu_seconds() - begin;
  report_surface(state, surface, seconds_per_evaluation(*field, seed), seconds);
}

vtkNew<vtkPolyData> polyline(const SeedCurve& seed, int count) {
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

TriangleMesh triangles_of(vtkPolyData* data) {
  TriangleMesh mesh;
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

void vtk_surface(benchmark::State& state, const ClosedForm& form, bool iterative, double spacing) {
  const auto field = make_field(form.field);
  const auto image = samples_of(*field, box_of(form), 32);
  const double length =
      pellucid::testing::sweep(form, "hultquist:threshold=0.1").surface.mesh.bounds().diagonal();
  TriangleMesh mesh;
  for (auto _ : state) {
    vtkNew<vtkStreamSurface> filter;
    filter->SetInputData(0, image);
    filter->SetInputData(1, polyline(form.seed, int(1 / spacing) + 1));
    filter->SetIntegratorTypeToRungeKutta4();
    filter->SetIntegrationDirectionToForward();
    filter->SetIntegrationStepUnit(vtkStreamTracer::LENGTH_UNIT);
    filter->SetInitialIntegrationStep(spacing);
    filter->SetMaximumPropagation(length);
    filter->SetUseIterativeSeeding(iterative);
    filter->Update();
    state.PauseTiming();
    vtkNew<vtkTriangleFilter> triangles;
    triangles->SetInputData(filter->GetOutput());
    triangles->Update();
    mesh = triangles_of(triangles->GetOutput());
    state.ResumeTiming();
  }
  state.counters["triangles"] = double(mesh.triangles.size());
  state.counters["max_error"] = pellucid::testing::largest_distance(form, mesh);
}

void our_surface(benchmark::State& state, const ClosedForm& form, const std::string& integrator,
                 bool from_samples) {
  auto field = make_field(form.field);
  if (from_samples) field = sampled(*field, box_of(form), 32);
  const SurfaceRequest request{field.get(), form.seed, form.duration, 0, false, {}};
  IntegratedSurface surface;
  const double begin = cpu_seconds();
  for (auto _ : state) surface = integrate_surface(integrator, request);
  const double seconds = cpu_seconds() - begin;
  report_surface(state, surface, seconds_per_evaluation(*field, form.seed.point_at(0.5)), seconds);
  state.counters["max_error"] = pellucid::testing::largest_distance(form, surface.mesh);
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
    for (const double tolerance : {1e-3, 1e-4})
      for (const bool from_samples : {false, true})
        add(fmt::format("{}/pellucid/{}/tolerance={}", form.name,
                        from_samples ? "samples" : "closed form", tolerance),
            our_surface, form, fmt::format("hultquist:tolerance={}", tolerance), from_samples);
    for (const double spacing : {0.04, 0.01})
      for (const bool iterative : {true, false})
        add(fmt::format("{}/vtk/{}/spacing={}", form.name, iterative ? "iterative" : "simple",
                        spacing),
            vtk_surface, form, iterative, spacing);
  }
}

}  // namespace

int main(int argc, char** argv) {
  for (const char* integrator :
       {"hultquist:threshold=0.05", "hultquist:threshold=0.01", "hultquist:tolerance=1e-4",
        "fixed-front:particles=1000,rows=400", "adaptive-front:threshold=0.05"})
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
