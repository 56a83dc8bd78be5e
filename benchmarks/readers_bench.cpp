// SPDX-License-Identifier: GPL-3.0-or-later
// What the boundary of readers costs: a file read in a process of its own, whose numbers come back
// as checked blocks, beside the same library's reader in this process; in turn, in one run.
//   ratio      ours over the library's alone, median of the pairs; bound 1.2 of large files
//   extra_ms   ours less the library's alone, median of the pairs; bound 10 ms of small files
// Files are in memory or in the system's cache after the first, untimed reading.

#include <benchmark/benchmark.h>
#include <openvdb/openvdb.h>
#include <vtkDataSet.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSphereSource.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLImageDataWriter.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <vector>

#include "readers/vdb/vdb_file.h"
#include "readers/vtk/vtk_file.h"
#include "tests/support/temporary_folder.h"

namespace pellucid {
namespace {

namespace fs = std::filesystem;
using Read = std::function<void()>;

template <class Writer>
fs::path write_vtk(const fs::path& path, vtkDataObject* data) {
  vtkNew<Writer> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputDataObject(data);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToNone();
  writer->Write();
  return path;
}

/// side³ vectors of floats.
fs::path image_file(const fs::path& folder, int side) {
  vtkNew<vtkImageData> image;
  image->SetDimensions(side, side, side);
  vtkNew<vtkFloatArray> velocity;
  velocity->SetName("velocity");
  velocity->SetNumberOfComponents(3);
  velocity->SetNumberOfTuples(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < velocity->GetNumberOfValues(); ++i)
    velocity->SetValue(i, std::sin(0.001f * float(i)));
  image->GetPointData()->AddArray(velocity);
  return write_vtk<vtkXMLImageDataWriter>(folder / "image.vti", image);
}

fs::path sphere_file(const fs::path& folder, int resolution) {
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(resolution);
  sphere->SetPhiResolution(resolution);
  sphere->Update();
  return write_vtk<vtkXMLPolyDataWriter>(folder / "sphere.vtp", sphere->GetOutput());
}

/// A dense box of side³ active voxels.
fs::path grid_file(const fs::path& folder, int side) {
  auto grid = openvdb::FloatGrid::create(0);
  grid->setName("density");
  auto accessor = grid->getAccessor();
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      for (int z = 0; z < side; ++z)
        accessor.setValue({x, y, z}, std::sin(0.1f * float(x * y)) + 0.01f * float(z));
  openvdb::io::File file(folder / "grid.vdb");
  file.setCompression(openvdb::io::COMPRESS_ACTIVE_MASK);
  file.write({grid});
  return folder / "grid.vdb";
}

template <class Reader>
void read_here(const fs::path& path) {
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  benchmark::DoNotOptimize(reader->GetOutputDataObject(0));
}

void read_grids_here(const fs::path& path) {
  openvdb::io::File file(path.string());
  file.setCopyMaxBytes(0);
  file.open(false);  // not delayed: all values are read
  benchmark::DoNotOptimize(file.getGrids());
}

double seconds(const Read& read) {
  const auto start = std::chrono::steady_clock::now();
  read();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values) {
  std::ranges::nth_element(values, values.begin() + std::ptrdiff_t(values.size() / 2));
  return values[values.size() / 2];
}

void compare(benchmark::State& state, const Read& here, const Read& apart) {
  here();
  apart();
  std::vector<double> ratios, extra;
  for (auto _ : state) {
    const double alone = seconds(here), ours = seconds(apart);
    ratios.push_back(ours / alone);
    extra.push_back(1e3 * (ours - alone));
    state.SetIterationTime(ours);
  }
  state.counters["ratio"] = median(ratios);
  state.counters["extra_ms"] = median(extra);
}

void add(const std::string& name, const Read& here, const Read& apart, int pairs) {
  benchmark::RegisterBenchmark(name.c_str(),
                               [=](benchmark::State& state) { compare(state, here, apart); })
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond)
      ->Iterations(pairs);
}

template <class Reader>
void add_vtk(const std::string& name, const fs::path& path, int pairs) {
  add(
      name, [path] { read_here<Reader>(path); }, [path] { readers::read_vtk_data_set(path); },
      pairs);
}

void add_vdb(const std::string& name, const fs::path& path, int pairs) {
  add(
      name, [path] { read_grids_here(path); }, [path] { readers::read_vdb_grids(path); }, pairs);
}

}  // namespace
}  // namespace pellucid

int main(int argc, char** argv) {
  using namespace pellucid;
  openvdb::initialize();
  const testing::TemporaryFolder small, large;
  add_vtk<vtkXMLPolyDataReader>("vtp/small", sphere_file(small.path(), 16), 31);
  add_vtk<vtkXMLImageDataReader>("vti/small", image_file(small.path(), 8), 31);
  add_vdb("vdb/small", grid_file(small.path(), 8), 31);
  add_vtk<vtkXMLPolyDataReader>("vtp/large", sphere_file(large.path(), 1500), 11);
  add_vtk<vtkXMLImageDataReader>("vti/large", image_file(large.path(), 256), 11);
  add_vdb("vdb/large", grid_file(large.path(), 256), 11);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
