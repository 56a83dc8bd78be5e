// SPDX-License-Identifier: GPL-3.0-or-later
// Image and rectilinear data become a dense array of our own; curvilinear and unstructured grids
// are searched with VTK's cell locator.

#include "fields/readers/vtk_field.h"

#include <fmt/format.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkRectilinearGrid.h>
#include <vtkUnsignedCharArray.h>

#include <limits>

#include "core/error.h"
#include "fields/files/vector_array.h"
#include "fields/finite.h"
#include "fields/sampled/cell_field.h"
#include "fields/sampled/dense_field.h"
#include "readers/vtk/shown_cells.h"
#include "readers/vtk/vtk_file.h"

namespace pellucid::fields {
namespace {

using Path = std::filesystem::path;

[[noreturn]] void fail(const Path& path, std::string_view why) {
  throw InputError(fmt::format("{}: {}", path.string(), why));
}

void require_two_samples(const int dimensions[3], const Path& path) {
  for (int axis = 0; axis < 3; ++axis)
    if (dimensions[axis] < 2)
      fail(path, fmt::format("{} × {} × {} samples; a field needs two or more along each axis",
                             dimensions[0], dimensions[1], dimensions[2]));
}

/// Axes of an image whose rows run along the world's axes, or its own axes in units of samples.
std::array<Axis, 3> axes_of(vtkImageData* image, bool turned, const Path& path) {
  const int* extent = image->GetExtent();
  const double *origin = image->GetOrigin(), *spacing = image->GetSpacing();
  const auto axis = [&](int a) {
    const double step = turned ? 1 : spacing[a];
    const double first = turned ? extent[2 * a] : origin[a] + extent[2 * a] * step;
    const auto count = std::size_t(image->GetDimensions()[a]);
    if (!Axis::can_be_uniform(first, step, count))
      fail(path, fmt::format("spacing {} from {} along axis {}", step, first, a));
    return Axis::uniform(first, step, count);
  };
  return {axis(0), axis(1), axis(2)};
}

std::optional<GridFrame> frame_of(vtkImageData* image, const Path& path) {
  if (image->GetDirectionMatrix()->IsIdentity()) return std::nullopt;
  Mat3 world_from_grid;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row)
      world_from_grid[column][row] =
          image->GetDirectionMatrix()->GetElement(row, column) * image->GetSpacing()[column];
  const Mat3 grid_from_world = glm::inverse(world_from_grid);
  const double* origin = image->GetOrigin();
  const Vec3 world_origin(origin[0], origin[1], origin[2]);
  if (!is_finite(grid_from_world) || !is_finite(world_origin))
    fail(path, "the image's directions do not span space");
  return GridFrame{grid_from_world, world_origin};
}

Axis axis_of(vtkDataArray* coordinates, int number, const Path& path) {
  std::vector<double> positions(std::size_t(coordinates->GetNumberOfTuples()));
  for (std::size_t i = 0; i < positions.size(); ++i)
    positions[i] = coordinates->GetComponent(vtkIdType(i), 0);
  for (std::size_t i = 0; i < positions.size(); ++i)
    if (!std::isfinite(positions[i]) || (i > 0 && !(positions[i] > positions[i - 1])))
      fail(path, fmt::format("coordinate {} of axis {} is {}; they have to ascend", i, number,
                             positions[i]));
  return Axis(std::move(positions));
}

/// Samples that the file hides become NaN.
template <class Sample>
std::vector<Sample> copy_samples(vtkDataSet* data, vtkDataArray* vectors) {
  std::vector<Sample> samples(std::size_t(vectors->GetNumberOfTuples()));
  const vtkUnsignedCharArray* ghosts = data->GetPointGhostArray();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    double v[3];
    vectors->GetTuple(vtkIdType(i), v);
    samples[i] = Sample(v[0], v[1], v[2]);
    if (ghosts && ghosts->GetValue(vtkIdType(i)) & vtkDataSetAttributes::HIDDENPOINT)
      samples[i] = Sample(std::numeric_limits<float>::quiet_NaN());
  }
  return samples;
}

struct DenseParts {
  std::array<Axis, 3> axes;
  std::optional<GridFrame> frame;
};

template <class Sample>
std::unique_ptr<VectorField> make_dense(DenseParts parts, vtkDataSet* data, vtkDataArray* vectors,
                                        Interpolation interpolation, std::string description) {
  return make_dense_field(
      DenseGrid<Sample>{std::move(parts.axes), copy_samples<Sample>(data, vectors), parts.frame},
      interpolation, std::move(description));
}

std::unique_ptr<VectorField> make_dense(DenseParts parts, vtkDataSet* data,
                                        const FileOptions& options, const Path& path) {
  vtkDataArray* vectors = pick_vectors(data, options.array, path);
  std::string description =
      fmt::format("{}: {} × {} × {} samples of {}", path.filename().string(), parts.axes[0].size(),
                  parts.axes[1].size(), parts.axes[2].size(),
                  vectors->GetName() ? vectors->GetName() : "vectors");
  if (vectors->GetDataType() == VTK_DOUBLE)
    return make_dense<Vec3>(std::move(parts), data, vectors, options.interpolation, description);
  return make_dense<glm::vec3>(std::move(parts), data, vectors, options.interpolation, description);
}

std::unique_ptr<VectorField> from_image(vtkImageData* image, const FileOptions& options,
                                        const Path& path) {
  require_two_samples(image->GetDimensions(), path);
  auto frame = frame_of(image, path);
  auto axes = axes_of(image, frame.has_value(), path);
  return make_dense({std::move(axes), frame}, image, options, path);
}

std::unique_ptr<VectorField> from_rectilinear(vtkRectilinearGrid* grid, const FileOptions& options,
                                              const Path& path) {
  require_two_samples(grid->GetDimensions(), path);
  vtkDataArray* coordinates[3] = {grid->GetXCoordinates(), grid->GetYCoordinates(),
                                  grid->GetZCoordinates()};
  for (int a = 0; a < 3; ++a)
    if (!coordinates[a] || coordinates[a]->GetNumberOfTuples() != grid->GetDimensions()[a])
      fail(path, fmt::format("axis {} does not have one coordinate per sample", a));
  return make_dense({{axis_of(coordinates[0], 0, path), axis_of(coordinates[1], 1, path),
                      axis_of(coordinates[2], 2, path)},
                     std::nullopt},
                    grid, options, path);
}

/// Hidden points alone can be had in a dense array: they are NaN there.
bool hides_some_cells(vtkDataSet* data) {
  return data->GetCellGhostArray() && readers::hides_cells(data);
}

}  // namespace

std::unique_ptr<VectorField> field_of(const vtkSmartPointer<vtkDataSet>& data,
                                      const FileOptions& options, const Path& path) {
  // A dense array has no cell that is missing: where some are hidden, cells are searched.
  const bool is_dense = !hides_some_cells(data);
  if (auto* image = vtkImageData::SafeDownCast(data); image && is_dense)
    return from_image(image, options, path);
  if (auto* grid = vtkRectilinearGrid::SafeDownCast(data); grid && is_dense)
    return from_rectilinear(grid, options, path);
  if (options.interpolation != Interpolation::linear)
    fail(path,
         "sampler=c1 needs image or rectilinear data without hidden cells; this grid takes "
         "sampler=linear");
  return make_cell_field(data, pick_vectors(data, options.array, path), path);
}

namespace {

std::unique_ptr<VectorField> read_vtk_field(const Path& path, const FileOptions& options) {
  return field_of(readers::read_vtk_data_set(path), options, path);
}

}  // namespace

std::vector<FileFormatRow> vtk_formats() {
  return {{".vti", "VTK image", read_vtk_field},
          {".vtr", "VTK rectilinear grid", read_vtk_field},
          {".vts", "VTK structured grid", read_vtk_field},
          {".vtu", "VTK unstructured grid", read_vtk_field},
          {".vtk", "legacy VTK", read_vtk_field}};
}

}  // namespace pellucid::fields
