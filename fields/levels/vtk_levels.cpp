// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/levels/vtk_levels.h"

#include <fmt/format.h>
#include <vtkAOSDataArrayTemplate.h>
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
#include "core/files/pages.h"
#include "fields/files/array_list.h"
#include "fields/files/vector_array.h"
#include "fields/levels/derived_scalar.h"
#include "readers/vtk/ascending_axes.h"
#include "readers/vtk/shown_cells.h"

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
    bad_file(
        path,
        "its axes are turned, or exchanged; accepted: x, y and z along the world's, either way "
        "round");
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
  // The mean; exactly the step where all are equal, which (0.2 + 0.2 + 0.2) / 3 is not.
  const double width = step.x + ((step.y - step.x) + (step.z - step.x)) / 3;
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

/// Whether every value of its type is a float.
bool holds_floats(const vtkDataArray& array) {
  const int type = const_cast<vtkDataArray&>(array).GetDataType();
  return type == VTK_FLOAT || const_cast<vtkDataArray&>(array).GetDataTypeSize() < 4;
}

/// The numbers of an array of one component, whose pages go back as they are copied where it is
/// large and nothing else has it.
template <class T>
std::vector<T> taken_numbers(vtkDataArray& array) {
  constexpr std::size_t at_once = std::size_t(1) << 23;
  const auto count = std::size_t(array.GetNumberOfTuples());
  std::vector<T> numbers;
  numbers.reserve(count);
  const auto* own = vtkArrayDownCast<vtkAOSDataArrayTemplate<T>>(&array);
  if (!own) {
    for (std::size_t i = 0; i < count; ++i)
      numbers.push_back(T(array.GetComponent(vtkIdType(i), 0)));
    return numbers;
  }
  const T* begin = const_cast<vtkAOSDataArrayTemplate<T>*>(own)->GetPointer(0);
  for (std::size_t done = 0; done < count; done = numbers.size()) {
    const std::size_t more = std::min(at_once, count - done);
    numbers.insert(numbers.end(), begin + done, begin + done + more);
    if (more == at_once && array.GetReferenceCount() == 1)
      forget_pages(begin + done, more * sizeof(T));
  }
  return numbers;
}

template <class T>
std::vector<Level<T>> scalars_in(const PointLattice& lattice, vtkDataArray& array, bool of_cells,
                                 const fs::path& path) {
  Level<T> level = empty_level<T>(lattice, of_cells, path);
  level.samples = taken_numbers<T>(array);
  check_level(path.string(), level);
  std::vector<Level<T>> levels;
  levels.push_back(std::move(level));
  return levels;
}

ExactLevels scalars_of_array(const PointLattice& lattice, vtkDataArray& array, bool of_cells,
                             const fs::path& path) {
  if (holds_floats(array)) return scalars_in<float>(lattice, array, of_cells, path);
  return exact(scalars_in<double>(lattice, array, of_cells, path));
}

template <class T>
std::vector<Level<T>> scalars_of_vectors(const PointLattice& lattice, const Vectors& vectors,
                                         const fs::path& path, std::string_view scalar) {
  using Sample = glm::vec<3, T>;
  auto level = empty_level<Sample>(lattice, vectors.of_cells, path);
  level.samples.reserve(std::size_t(vectors.values->GetNumberOfTuples()));
  for (vtkIdType i = 0; i < vectors.values->GetNumberOfTuples(); ++i) {
    double v[3];
    vectors.values->GetTuple(i, v);
    level.samples.emplace_back(v[0], v[1], v[2]);
  }
  check_level(path.string(), level);
  return scalars_of(std::vector{std::move(level)}, scalar);
}

ExactLevels derived_level(vtkDataSet& data, const PointLattice& lattice, const fs::path& path,
                          std::string_view scalar, const std::string& velocity) {
  const bool has_points = data.GetPointData()->GetNumberOfArrays() > 0;
  const Vectors vectors =
      pick_vectors(data, velocity, has_points ? CellValues::averaged : CellValues::constant, path);
  if (holds_floats(*vectors.values))
    return scalars_of_vectors<float>(lattice, vectors, path, scalar);
  return exact(scalars_of_vectors<double>(lattice, vectors, path, scalar));
}

vtkDataArray* scalar_in(vtkDataSetAttributes& arrays, const std::string& name) {
  vtkDataArray* array = arrays.GetArray(name.c_str());
  return array && array->GetNumberOfComponents() == 1 ? array : nullptr;
}

constexpr std::string_view point_prefix = "point:", cell_prefix = "cell:";

}  // namespace

ArrayChoice::ArrayChoice(std::string_view scalar)
    : of_points(!scalar.starts_with(cell_prefix)), of_cells(!scalar.starts_with(point_prefix)) {
  if (!of_points) scalar.remove_prefix(cell_prefix.size());
  if (!of_cells) scalar.remove_prefix(point_prefix.size());
  name = scalar;
}

ExactLevels level_of(vtkDataSet& data, const fs::path& path, std::string_view scalar,
                     const std::string& velocity) {
  readers::make_axes_ascend(data);
  const PointLattice lattice = lattice_of(data, path);
  const ArrayChoice choice(scalar);
  vtkDataArray* const of_points =
      choice.of_points ? scalar_in(*data.GetPointData(), choice.name) : nullptr;
  if (of_points) return scalars_of_array(lattice, *of_points, false, path);
  vtkDataArray* const of_cells =
      choice.of_cells ? scalar_in(*data.GetCellData(), choice.name) : nullptr;
  if (of_cells) return scalars_of_array(lattice, *of_cells, true, path);
  if (is_derived(scalar)) return derived_level(data, lattice, path, scalar, velocity);
  bad_file(path,
           fmt::format("no array is the scalar '{}'; arrays: {}", scalar, describe_arrays(data)));
}

std::string remark_on_choice(vtkDataSet& data, const fs::path& path, std::string_view scalar) {
  const ArrayChoice choice(scalar);
  if (!choice.of_points || !choice.of_cells || !scalar_in(*data.GetPointData(), choice.name) ||
      !scalar_in(*data.GetCellData(), choice.name))
    return {};
  return fmt::format("of {} the scalar {} of the points is drawn; cell:{} is that of the cells",
                     path.filename().string(), choice.name, choice.name);
}

}  // namespace pellucid::fields
