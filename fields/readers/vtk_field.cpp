// SPDX-License-Identifier: GPL-3.0-or-later
// Image and rectilinear data are a dense array, VTK's own where it lies as ours does; curvilinear
// and unstructured grids are searched cell by cell.

#include "fields/readers/vtk_field.h"

#include <fmt/format.h>
#include <vtkAOSDataArrayTemplate.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkRectilinearGrid.h>

#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "core/files/bad_file.h"
#include "fields/files/periods.h"
#include "fields/files/vector_array.h"
#include "fields/finite.h"
#include "fields/readers/grid_source.h"
#include "fields/readers/series_field.h"
#include "fields/sampled/cell_field.h"
#include "readers/vtk/ascending_axes.h"
#include "readers/vtk/shown_cells.h"
#include "readers/vtk/vtk_file.h"
#include "readers/vtk/vtk_formats.h"

namespace pellucid::fields {
namespace {

using Path = std::filesystem::path;

/// Axes of an image whose rows run along the world's axes, or its own axes in units of samples.
std::array<FileAxis, 3> axes_of(vtkImageData* image, bool turned, const Path& path) {
  const int* extent = image->GetExtent();
  const double *origin = image->GetOrigin(), *spacing = image->GetSpacing();
  const auto axis = [&](int a) {
    const double step = turned ? 1 : spacing[a];
    const double first = turned ? extent[2 * a] : origin[a] + extent[2 * a] * step;
    const auto count = std::size_t(image->GetDimensions()[a]);
    if (count == 1 && std::isfinite(first)) return FileAxis{std::nullopt, first};
    if (!Axis::can_be_uniform(first, step, count))
      bad_file(path, fmt::format("spacing {} from {} along axis {}", step, first, a));
    return FileAxis{Axis::uniform(first, step, count)};
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
    bad_file(path, "the image's directions do not span space");
  return GridFrame{grid_from_world, world_origin};
}

/// An even axis, within a billionth of a cell, needs no search.
Axis even_or_not(std::vector<double> positions) {
  constexpr double rounding = 1e-9;
  const std::size_t count = positions.size();
  const double first = positions.front(), step = (positions.back() - first) / double(count - 1);
  bool is_even = Axis::can_be_uniform(first, step, count);
  for (std::size_t i = 0; i < count && is_even; ++i)
    is_even = std::abs(positions[i] - (first + double(i) * step)) <= rounding * step;
  return is_even ? Axis::uniform(first, step, count) : Axis(std::move(positions));
}

FileAxis axis_of(vtkDataArray* coordinates, int number, const Path& path) {
  std::vector<double> positions(std::size_t(coordinates->GetNumberOfTuples()));
  for (std::size_t i = 0; i < positions.size(); ++i)
    positions[i] = coordinates->GetComponent(vtkIdType(i), 0);
  for (std::size_t i = 0; i < positions.size(); ++i)
    if (!std::isfinite(positions[i]) || (i > 0 && !(positions[i] > positions[i - 1])))
      bad_file(path,
               fmt::format("coordinate {} of axis {} is {}; they have to ascend, or to descend", i,
                           number, positions[i]));
  if (positions.size() == 1) return {std::nullopt, positions.front()};
  return {even_or_not(std::move(positions))};
}

/// The array's own numbers, where they lie in memory as samples do.
template <class Sample>
std::optional<SharedSamples<Sample>> own_samples(vtkDataArray& array) {
  using Number = typename Sample::value_type;
  static_assert(sizeof(Sample) == 3 * sizeof(Number));
  auto* numbers = vtkArrayDownCast<vtkAOSDataArrayTemplate<Number>>(&array);
  if (!numbers) return std::nullopt;
  const auto* first = reinterpret_cast<const Sample*>(numbers->GetPointer(0));
  return SharedSamples<Sample>({first, std::size_t(array.GetNumberOfTuples())},
                               std::make_shared<vtkSmartPointer<vtkDataArray>>(&array));
}

/// Samples that the file hides become NaN.
template <class Sample>
SharedSamples<Sample> samples_of(vtkDataSet* data, const Vectors& vectors) {
  const bool hides = !vectors.of_cells && data->GetPointGhostArray();
  if (!hides)
    if (auto own = own_samples<Sample>(*vectors.values)) return *std::move(own);
  std::vector<Sample> samples(std::size_t(vectors.values->GetNumberOfTuples()));
  for (std::size_t i = 0; i < samples.size(); ++i) {
    double v[3];
    vectors.values->GetTuple(vtkIdType(i), v);
    samples[i] = Sample(v[0], v[1], v[2]);
    if (hides && readers::hides_point(data, vtkIdType(i)))
      samples[i] = Sample(std::numeric_limits<float>::quiet_NaN());
  }
  return samples;
}

/// Where a file's grid along axes has its samples.
struct Shape {
  std::array<FileAxis, 3> axes;
  std::optional<GridFrame> frame;
};

Shape shape_of(vtkImageData* image, const Path& path) {
  const auto frame = frame_of(image, path);
  return {axes_of(image, frame.has_value(), path), frame};
}

Shape shape_of(vtkRectilinearGrid* grid, const Path& path) {
  vtkDataArray* coordinates[3] = {grid->GetXCoordinates(), grid->GetYCoordinates(),
                                  grid->GetZCoordinates()};
  for (int a = 0; a < 3; ++a)
    if (!coordinates[a] || coordinates[a]->GetNumberOfTuples() != grid->GetDimensions()[a])
      bad_file(path, fmt::format("axis {} does not have one coordinate per sample", a));
  return {{axis_of(coordinates[0], 0, path), axis_of(coordinates[1], 1, path),
           axis_of(coordinates[2], 2, path)},
          std::nullopt};
}

Interpolation interpolation_of(const Vectors& vectors, const FileOptions& options,
                               const Path& path) {
  if (!vectors.of_cells) return options.interpolation;
  if (options.interpolation == Interpolation::c1)
    bad_file(path,
             "sampler=c1: values that are constant in cells have no slope; accepted: "
             "cells=averaged");
  return Interpolation::constant;
}

template <class Sample>
std::unique_ptr<VectorField> make_dense_of(Shape shape, vtkDataSet* data, const Vectors& vectors,
                                           const FileOptions& options, const Path& path) {
  const auto count = [&](std::size_t a) {
    return shape.axes[a].axis ? shape.axes[a].axis->size() : 1;
  };
  std::string description = fmt::format("{}: {} × {} × {} samples of {}", path.filename().string(),
                                        count(0), count(1), count(2), vectors.title);
  return make_grid_field(GridSource<Sample>{
      std::move(shape.axes), samples_of<Sample>(data, vectors), shape.frame,
      interpolation_of(vectors, options, path), periods_of(options, path.string()),
      vectors.averaged, vectors.quantity, path.string(), std::move(description)});
}

std::unique_ptr<VectorField> make_dense(Shape shape, vtkDataSet* data, const Vectors& vectors,
                                        const FileOptions& options, const Path& path) {
  if (vectors.values->GetDataType() == VTK_DOUBLE)
    return make_dense_of<Vec3>(std::move(shape), data, vectors, options, path);
  return make_dense_of<glm::vec3>(std::move(shape), data, vectors, options, path);
}

/// Cells are searched one by one: they have neither slopes nor an end that is a beginning.
void require_plain(const FileOptions& options, const Path& path) {
  if (options.interpolation != Interpolation::linear)
    bad_file(path,
             "sampler=c1 needs image or rectilinear data without hidden cells; this grid takes "
             "sampler=linear");
  if (parse_periods(options.periodic, path.string()).any())
    bad_file(path,
             fmt::format("periodic={} needs image or rectilinear data without hidden cells; this "
                         "grid takes periodic=none",
                         options.periodic));
}

/// Hidden points alone can be had in a dense array: they are NaN there.
bool hides_some_cells(vtkDataSet* data) {
  return data->GetCellGhostArray() && readers::hides_cells(data);
}

}  // namespace

std::unique_ptr<VectorField> field_of(const vtkSmartPointer<vtkDataSet>& data,
                                      const FileOptions& options, const Path& path,
                                      const std::string& note) {
  readers::make_axes_ascend(*data);
  Vectors vectors =
      pick_vectors(*data, wanted_array(options), options.cells, path, options.quantity);
  keep_array(options, vectors.name);
  vectors.title += note;
  // A dense array has no cell that is missing: where some are hidden, cells are searched.
  const bool is_dense = !hides_some_cells(data);
  if (auto* image = vtkImageData::SafeDownCast(data); image && is_dense)
    return make_dense(shape_of(image, path), data, vectors, options, path);
  if (auto* grid = vtkRectilinearGrid::SafeDownCast(data); grid && is_dense)
    return make_dense(shape_of(grid, path), data, vectors, options, path);
  require_plain(options, path);
  return make_cell_field(data, vectors, path);
}

namespace {

std::string note_of(const std::vector<std::string>& blocks) {
  if (blocks.empty()) return {};
  if (blocks.size() == 1) return fmt::format(", block {}", blocks.front());
  return fmt::format(", {} blocks merged", blocks.size());
}

std::unique_ptr<VectorField> read_vtk_field(const Path& path, const FileOptions& asked) {
  const FileOptions options = in_common(asked);
  const auto read =
      readers::read_vtk_file(path, options.block, options.time, wanted_array(options));
  std::vector<double> times;
  for (const readers::VtkTime& one : read) times.push_back(one.time);
  return field_over_times(times, {}, path, [&](std::size_t number) {
    return field_of(read[number].data, options, path, note_of(read[number].blocks));
  });
}

}  // namespace

std::vector<FileFormatRow> vtk_formats() {
  std::vector<FileFormatRow> rows;
  for (const readers::VtkFormat& format : readers::vtk_formats())
    if (!format.without_arrays)
      rows.push_back({format.ending, format.title, read_vtk_field, format.traps});
  return rows;
}

}  // namespace pellucid::fields
