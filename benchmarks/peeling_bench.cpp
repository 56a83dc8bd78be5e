// SPDX-License-Identifier: GPL-3.0-or-later
// `raytrace` and VTK's dual depth peeling, run to its end, draw the same scenes in turn: `ratio` is
// VTK's time over raytrace's, median of the pairs; `rmse` is that of VTK's picture from the exact
// one, which has none. VTK's OpenGL driver is the machine's (Mesa's llvmpipe under xvfb-run).
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cstdlib>

#include "compare/pictures/metrics.h"
#include "core/machine/stopwatch.h"
#include "fields/make_field.h"
#include "groundtruth/methods/raytrace.h"
#include "integrators/surfaces/integrate_surface.h"

namespace {

using namespace pellucid;

constexpr int side = 1000;  // pixels
/// α = 0.3 as 8 bits hold it.
const double alpha = 77 / 255.0;

/// 32 quads, each larger than the picture.
scene::Scene full_screen_quads() {
  scene::Scene scene;
  scene.camera.projection = scene::Projection::orthographic;
  for (int i = 0; i < 32; ++i) {
    geometry::TriangleMesh quad;
    const double z = 1 - i / 16.0;
    quad.positions = {{-2, -2, z}, {2, -2, z}, {2, 2, z}, {-2, 2, z}};
    quad.triangles = {{0, 1, 2}, {0, 2, 3}};
    quad.colors.assign(4, Rgba(i * 8 / 255.0, 0.2, 1 - i * 8 / 255.0, alpha));
    scene.objects.push_back({"quad", quad});
  }
  return scene;
}

/// 24 stream surfaces of the ABC flow, 16 000 triangles each.
scene::Scene abc_surfaces() {
  scene::Scene scene;
  scene.camera.eye = Vec3(27, 11, 4);
  scene.camera.target = Vec3(2.5, 3.3, 3);
  scene.camera.fov = 36;
  const auto field = fields::make_field("abc");
  for (int i = 0; i < 24; ++i) {
    const Vec3 from(0.25 * i, 0.2, 3.14);
    const integrators::SurfaceRequest request{
        field.get(), integrators::segment_seed(from, from + Vec3(0, 6, 0)), 4, 0, false, {}};
    geometry::TriangleMesh mesh =
        integrators::integrate_surface("fixed-front:particles=81,rows=100", request).mesh;
    mesh.colors.assign(mesh.positions.size(), Rgba(i * 10 / 255.0, 0.4, 0.6, alpha));
    scene.objects.push_back({"surface", std::move(mesh)});
  }
  return scene;
}

vtkNew<vtkActor> actor_of(const geometry::TriangleMesh& mesh) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(4);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Vec3& x = mesh.positions[i];
    points->InsertNextPoint(x.x, x.y, x.z);
    const Rgba& c = mesh.colors[i];
    colors->InsertNextTuple4(std::lround(255 * c.r), std::lround(255 * c.g), std::lround(255 * c.b),
                             std::lround(255 * c.a));
  }
  vtkNew<vtkCellArray> triangles;
  for (const auto& t : mesh.triangles) triangles->InsertNextCell({t[0], t[1], t[2]});
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(triangles);
  data->GetPointData()->SetScalars(colors);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetColorModeToDirectScalars();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->ForceTranslucentOn();
  return actor;
}

/// The scene as VTK draws it, off screen.
class VtkPeeling {
 public:
  explicit VtkPeeling(const scene::Scene& scene) {
    for (const scene::SceneObject& object : scene.objects)
      renderer_->AddActor(actor_of(object.mesh()));
    renderer_->SetBackground(scene.background.r, scene.background.g, scene.background.b);
    renderer_->SetUseDepthPeeling(true);
    renderer_->SetMaximumNumberOfPeels(1000);
    renderer_->SetOcclusionRatio(0);  // until no pixel has a layer left
    window_->SetOffScreenRendering(true);
    window_->SetMultiSamples(0);
    window_->SetAlphaBitPlanes(true);
    window_->SetSize(scene.width, scene.height);
    window_->AddRenderer(renderer_);
    aim(scene.camera);
  }

  void render() {
    window_->Render();
    window_->WaitForCompletion();
  }

  Image image() {
    vtkNew<vtkUnsignedCharArray> bytes;
    window_->GetPixelData(0, 0, side - 1, side - 1, 0, bytes);
    Image image(side, side);
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x)
        for (int c = 0; c < 3; ++c)
          image.at(x, side - 1 - y)[c] = bytes->GetValue(3 * (vtkIdType(y) * side + x) + c) / 255.f;
    return image;
  }

 private:
  void aim(const scene::Camera& camera) {
    vtkCamera* view = renderer_->GetActiveCamera();
    view->SetPosition(camera.eye.x, camera.eye.y, camera.eye.z);
    view->SetFocalPoint(camera.target.x, camera.target.y, camera.target.z);
    view->SetViewUp(camera.up.x, camera.up.y, camera.up.z);
    view->SetViewAngle(camera.fov);
    view->SetParallelProjection(camera.projection == scene::Projection::orthographic);
    view->SetParallelScale(camera.height / 2);
    renderer_->ResetCameraClippingRange();
  }

  vtkNew<vtkRenderer> renderer_;
  vtkNew<vtkRenderWindow> window_;
};

double seconds_of(const auto& work) {
  const Stopwatch watch;
  work();
  return watch.seconds();
}

void against_vtk(benchmark::State& state, scene::Scene (*make_scene)()) {
  scene::Scene scene = make_scene();
  scene.width = scene.height = side;
  const scene::MethodRow& row = groundtruth::raytrace_method();
  const auto exact = row.make(scene, Parameters(row.name, row.parameters, {}), {});
  VtkPeeling vtk(scene);
  vtk.render();
  const scene::Rendering truth = exact->render({.layers = true});
  std::vector<double> ratios, vtk_times;
  for (auto _ : state) {
    const double seconds = seconds_of([&] { exact->render({}); });
    state.SetIterationTime(seconds);
    vtk_times.push_back(seconds_of([&] { vtk.render(); }));
    ratios.push_back(vtk_times.back() / seconds);
  }
  std::ranges::sort(ratios);
  std::ranges::sort(vtk_times);
  state.counters["ratio"] = ratios[ratios.size() / 2];
  state.counters["vtk_ms"] = 1e3 * vtk_times[vtk_times.size() / 2];
  state.counters["rmse"] = compare::rmse(truth.image, vtk.image());
  state.counters["crossings"] = double(truth.stats.fragments);
  state.counters["layers"] = truth.stats.max_layers;
}

}  // namespace

int main(int argc, char** argv) {
  if (!std::getenv("DISPLAY")) {
    fmt::print(stderr, "bench_peeling: VTK needs a display; try xvfb-run bench_peeling\n");
    return 2;
  }
  benchmark::Initialize(&argc, argv);
  const auto add = [](const char* name, scene::Scene (*scene)()) {
    benchmark::RegisterBenchmark(name,
                                 [scene](benchmark::State& state) { against_vtk(state, scene); })
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond)
        ->Iterations(5);
  };
  add("32-full-screen-quads", full_screen_quads);
  add("24-abc-surfaces", abc_surfaces);
  benchmark::RunSpecifiedBenchmarks();
}
