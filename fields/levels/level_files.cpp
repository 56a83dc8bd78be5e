// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/levels/level_files.h"

#include <fmt/format.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkPointData.h>
#include <vtkRectilinearGrid.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/files/bad_file.h"
#include "fields/files/array_list.h"
#include "fields/files/vector_array.h"
#include "fields/levels/derived_scalar.h"
#include "fields/levels/vdb_levels.h"
#include "readers/vdb/vdb_file.h"
#include "readers/vtk/ascending_axes.h"
#include "readers/vtk/shown_cells.h"
#include "readers/vtk/times.h"
#include "readers/vtk/vtk_file.h"
#include "readers/vtk/vtk_formats.h"

namespace pellucid::fields {
namespace {

namespace fs = std::filesystem;

// Of a cell: spacings are written in decimals, coordinates kept in floats.
constexpr double cube_rounding = 1e-5;

/// A grid of points along the axes: its first one, the step along each, and how many there are.
struct PointLattice {
  Vec3 origin{0}, step{0};
  std::array<int, 3> size{};
};

PointLattice lattice_of(vtkImageData& image, const fs::path& path) {
  if (!image.GetDirectionMatrix()->IsIdentity())
    bad_file(path, "its axes are turned; accepted: axes along the world's");
  PointLattice lattice;
  image.GetDimensions(lattice.size.data());
  double first[3];
  image.GetPoint(0, first);
  for (int a = 0; a < 3; ++a) lattice.origin[a] = first[a], lattice.step[a] = image.GetSpacing()[a];
  return lattice;
}

PointLattice lattice_of(vtkRectilinearGrid& grid, const fs::path& path) {
  PointLattice lattice;
  grid.GetDimensions(lattice.size.data());
  vtkDataArray* axes[3] = {grid.GetXCoordinates(), grid.GetYCoordinates(), grid.GetZCoordinates()};
  for (int a = 0; a < 3; ++a) {
    const int count = lattice.size[std::size_t(a)];
    lattice.origin[a] = axes[a]->GetComponent(0, 0);
    lattice.step[a] = (axes[a]->GetComponent(count - 1, 0) - lattice.origin[a]) / (count - 1);
    for (int i = 0; i < count; ++i)
      if (const double off = axes[a]->GetComponent(i, 0) - lattice.origin[a] - i * lattice.step[a];
          !(std::abs(off) <= cube_rounding * std::abs(lattice.step[a])))
        bad_file(path, fmt::format("its spacing along {} is not even; accepted: cubes. ParaView: "
                                   "Resample To Image",
                                   "xyz"[a]));
  }
  return lattice;
}

PointLattice lattice_of(vtkDataSet& data, const fs::path& path) {
  if (readers::hides_cells(&data))
    bad_file(path, "it hides some cells; accepted of an isosurface: grids without");
  if (auto* image = vtkImageData::SafeDownCast(&data)) return lattice_of(*image, path);
  if (auto* grid = vtkRectilinearGrid::SafeDownCast(&data)) return lattice_of(*grid, path);
  bad_file(path,
           fmt::format("it holds a {}; accepted of an isosurface: images and rectilinear grids. "
                       "ParaView: Resample To Image, or Contour, saved as .ply",
                       data.GetClassName()));
}

/// The lattice's own width. Throws InputError where cells are no cubes.
double width_of(const PointLattice& lattice, const fs::path& path) {
  const Vec3& step = lattice.step;
  const double width = (step.x + step.y + step.z) / 3;
  for (int a = 0; a < 3; ++a)
    if (!(std::abs(step[a] - width) <= cube_rounding * width))
      bad_file(path,
               fmt::format("its cells are {} × {} × {}; accepted: cubes. ParaView: Resample To "
                           "Image",
                           step.x, step.y, step.z));
  return width;
}

/// The level without its samples: at the lattice's points, or in the middle of its cells.
template <class T>
Level<T> empty_level(const PointLattice& lattice, bool of_cells, const fs::path& path) {
  Level<T> level{lattice.origin, width_of(lattice, path), lattice.size, {}};
  if (!of_cells) return level;
  level.origin += 0.5 * level.width;
  for (int& count : level.size) count = std::max(count - 1, 1);
  return level;
}

ScalarLevel scalars_of_array(const PointLattice& lattice, vtkDataArray& array, bool of_cells,
                             const fs::path& path) {
  ScalarLevel level = empty_level<float>(lattice, of_cells, path);
  level.samples.reserve(std::size_t(array.GetNumberOfTuples()));
  for (vtkIdType i = 0; i < array.GetNumberOfTuples(); ++i)
    level.samples.push_back(float(array.GetComponent(i, 0)));
  check_level(path.string(), level);
  return level;
}

ScalarLevel derived_level(vtkDataSet& data, const PointLattice& lattice, const fs::path& path,
                          std::string_view scalar, const std::string& velocity) {
  const bool has_points = data.GetPointData()->GetNumberOfArrays() > 0;
  const Vectors vectors =
      pick_vectors(data, velocity, has_points ? CellValues::averaged : CellValues::constant, path);
  VectorLevel level = empty_level<glm::vec3>(lattice, vectors.of_cells, path);
  for (vtkIdType i = 0; i < vectors.values->GetNumberOfTuples(); ++i) {
    double v[3];
    vectors.values->GetTuple(i, v);
    level.samples.emplace_back(v[0], v[1], v[2]);
  }
  check_level(path.string(), level);
  return scalars_of(std::vector{std::move(level)}, scalar).front();
}

vtkDataArray* scalar_in(vtkDataSetAttributes& arrays, std::string_view name) {
  vtkDataArray* array = arrays.GetArray(std::string(name).c_str());
  return array && array->GetNumberOfComponents() == 1 ? array : nullptr;
}

bool is_derived(std::string_view scalar) {
  return std::ranges::any_of(derived_scalars(),
                             [&](const auto& row) { return row.name == scalar; });
}

}  // namespace

ScalarLevel level_of(vtkDataSet& data, const fs::path& path, std::string_view scalar,
                     const std::string& velocity) {
  readers::make_axes_ascend(data);
  const PointLattice lattice = lattice_of(data, path);
  if (vtkDataArray* array = scalar_in(*data.GetPointData(), scalar))
    return scalars_of_array(lattice, *array, false, path);
  if (vtkDataArray* array = scalar_in(*data.GetCellData(), scalar))
    return scalars_of_array(lattice, *array, true, path);
  if (is_derived(scalar)) return derived_level(data, lattice, path, scalar, velocity);
  bad_file(path,
           fmt::format("no array is the scalar '{}'; arrays: {}", scalar, describe_arrays(data)));
}

namespace {

FileLevels read_vdb_file(const fs::path& path, std::string_view scalar, const std::string& velocity,
                         const std::string& time) {
  if (!time.empty()) readers::chosen_time({}, time, path);  // throws: it has none
  const auto grids = readers::read_vdb_grids(path);
  FileLevels file;
  file.levels = levels_of(grids, path, scalar, velocity);
  file.range = value_range(grids, scalar, file.levels);
  file.gaps = value_gaps(grids, scalar);
  return file;
}

}  // namespace

FileLevels read_levels(const fs::path& path, std::string_view scalar, const std::string& velocity,
                       const std::string& time) {
  if (!readers::vtk_format(path)) return read_vdb_file(path, scalar, velocity, time);
  const bool of_velocity = is_derived(scalar) && !velocity.empty();
  const readers::VtkTime read = readers::read_vtk_file(path, {}, time.empty() ? "first" : time,
                                                       of_velocity ? velocity : std::string(scalar))
                                    .front();
  FileLevels file;
  file.levels = {level_of(*read.data, path, scalar, velocity)};
  file.range = sample_range(file.levels);
  if (time.empty() && read.of > 1)
    file.remark = fmt::format("{} is drawn at {}, the first of its {} times",
                              path.filename().string(), read.time, read.of);
  return file;
}

}  // namespace pellucid::fields
