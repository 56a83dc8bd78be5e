// SPDX-License-Identifier: GPL-3.0-or-later
// The meanings are those of "Definition of NRRD File Format",
// teem.sourceforge.net/nrrd/format.html. Teem's library reads the file; VTK 9.1's own reader loses
// layers where `space` stands before `sizes`.

#include "readers/simulations/make_nrrd.h"

#include <fmt/format.h>
#include <teem/nrrd.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkTrivialProducer.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <glm/glm.hpp>
#include <memory>
#include <optional>

#include "core/error.h"
#include "readers/simulations/placed_image.h"
#include "readers/vtk/case_files.h"
#include "readers/vtk/vtk_type.h"

namespace pellucid::readers {
namespace {

using Path = std::filesystem::path;

struct Nuke {
  void operator()(Nrrd* nrrd) const { nrrdNuke(nrrd); }
};
using OwnNrrd = std::unique_ptr<Nrrd, Nuke>;

[[noreturn]] void fail(const Path& path, const std::string& why) {
  throw InputError(fmt::format("{}: {}", path.string(), why));
}

/// Teem complains in a line for each function that passed the complaint on. The last line is of the
/// one that found the fault: it is told.
[[noreturn]] void fail_as_teem(const Path& path) {
  const std::unique_ptr<char, decltype(&std::free)> text(biffGetDone(NRRD), std::free);
  std::string why = text ? text.get() : "";
  why.erase(why.find_last_not_of(" \n") + 1);
  fail(path, "not a valid NRRD file: " + why.substr(why.rfind('\n') + 1));
}

OwnNrrd load(const Path& path) {
  OwnNrrd nrrd(nrrdNew());
  if (nrrdLoad(nrrd.get(), path.c_str(), nullptr)) fail_as_teem(path);
  if (nrrd->type == nrrdTypeBlock) fail(path, "samples of blocks; accepted: numbers");
  return nrrd;
}

/// Which axes are of space, and which one is of the numbers of a sample.
struct Axes {
  std::vector<unsigned> space;
  std::optional<unsigned> row;
};

/// Finds them by their kinds. Where these are not known, the first of four axes holds the numbers,
/// as in files of vectors.
Axes axes_of(const Nrrd& nrrd, const Path& path) {
  Axes axes;
  for (unsigned a = 0; a < nrrd.dim; ++a) {
    const NrrdAxisInfo& axis = nrrd.axis[a];
    if (axis.kind == nrrdKindTime && axis.size > 1)
      fail(path, fmt::format("{} samples over time; accepted: one", axis.size));
    const bool is_row =
        axis.kind == nrrdKindUnknown ? a == 0 && nrrd.dim == 4 : !nrrdKindIsDomain(axis.kind);
    if (is_row && axes.row) fail(path, "two axes of numbers in a sample; accepted: one");
    if (is_row)
      axes.row = a;
    else if (axis.kind != nrrdKindTime)
      axes.space.push_back(a);
  }
  if (axes.space.size() < 2 || axes.space.size() > 3)
    fail(path, fmt::format("{} axes of space; accepted: 2 or 3", axes.space.size()));
  return axes;
}

/// Has the numbers of a sample beside each other.
OwnNrrd with_rows_first(OwnNrrd nrrd, const Axes& axes, const Path& path) {
  if (axes.row.value_or(0) == 0) return nrrd;
  std::vector<unsigned> order{*axes.row};
  for (unsigned a = 0; a < nrrd->dim; ++a)
    if (a != *axes.row) order.push_back(a);
  OwnNrrd turned(nrrdNew());
  if (nrrdAxesPermute(turned.get(), nrrd.get(), order.data())) fail_as_teem(path);
  return turned;
}

/// Teem numbers its types as NumberType does, from 1.
NumberType type_of(const Nrrd& nrrd) {
  static_assert(nrrdTypeChar == 1 + int(NumberType::i8) &&
                nrrdTypeULLong == 1 + int(NumberType::u64));
  static_assert(nrrdTypeDouble == 1 + int(NumberType::f64));
  return NumberType(nrrd.type - 1);
}

vtkSmartPointer<vtkDataArray> samples_of(const Nrrd& nrrd, std::size_t components) {
  const std::size_t numbers = nrrdElementNumber(&nrrd);
  vtkSmartPointer<vtkDataArray> array;
  array.TakeReference(vtkDataArray::CreateDataArray(vtk_type(type_of(nrrd))));
  array->SetName("NRRD");
  array->SetNumberOfComponents(int(components));
  array->SetNumberOfTuples(vtkIdType(numbers / components));
  std::memcpy(array->GetVoidPointer(0), nrrd.data, numbers * nrrdElementSize(&nrrd));
  return array;
}

/// To RAS, as .nii and .trk are; spaces without anatomy stay as they are.
glm::dvec3 signs_of(int space) {
  if (space == nrrdSpaceLeftPosteriorSuperior || space == nrrdSpaceScannerXYZ) return {-1, -1, 1};
  if (space == nrrdSpaceLeftAnteriorSuperior) return {-1, 1, 1};
  return {1, 1, 1};
}

glm::dvec3 vector_in(const double* numbers) { return {numbers[0], numbers[1], numbers[2]}; }

/// Where an image's points are: steps along its axes, and the first point.
struct Placement {
  std::array<glm::dvec3, 3> steps{glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)};
  glm::dvec3 origin{0};
};

Placement in_space(const Nrrd& nrrd, const Axes& axes, const Path& path) {
  if (nrrd.spaceDim != 3)
    fail(path, fmt::format("a space of {} dimensions; accepted: 3", nrrd.spaceDim));
  const glm::dvec3 signs = signs_of(nrrd.space);
  Placement placement;
  for (std::size_t i = 0; i < axes.space.size(); ++i)
    placement.steps[i] = signs * vector_in(nrrd.axis[axes.space[i]].spaceDirection);
  if (axes.space.size() == 2)
    placement.steps[2] = glm::normalize(glm::cross(placement.steps[0], placement.steps[1]));
  if (std::isfinite(nrrd.spaceOrigin[0])) placement.origin = signs * vector_in(nrrd.spaceOrigin);
  return placement;
}

/// By spacings, or by where an axis begins and ends: at samples, or at the borders of cells where
/// it says that these are centered so.
Placement by_axes(const Nrrd& nrrd, const Axes& axes) {
  Placement placement;
  for (std::size_t i = 0; i < axes.space.size(); ++i) {
    const NrrdAxisInfo& axis = nrrd.axis[axes.space[i]];
    const bool of_cells = axis.center == nrrdCenterCell;
    double step = axis.spacing;
    if (!std::isfinite(step) && std::isfinite(axis.max - axis.min) && axis.size > 1)
      step = (axis.max - axis.min) / double(of_cells ? axis.size : axis.size - 1);
    if (!std::isfinite(step)) step = 1;
    placement.steps[i] *= step;
    if (std::isfinite(axis.min)) placement.origin[int(i)] = axis.min + (of_cells ? 0.5 * step : 0);
  }
  return placement;
}

/// Brings vectors from their frame of measurement, whose columns are vectors of the file's space,
/// into the space that the image is in.
void turn_vectors(vtkImageData& image, const Nrrd& nrrd) {
  vtkDataArray* vectors = image.GetPointData()->GetArray("NRRD");
  const glm::dvec3 signs = signs_of(nrrd.space);
  const bool has_frame = nrrd.spaceDim == 3 && std::isfinite(nrrd.measurementFrame[0][0]);
  if (vectors->GetNumberOfComponents() != 3 || (!has_frame && signs == glm::dvec3(1))) return;
  glm::dmat3 frame(1);
  for (int c = 0; has_frame && c < 3; ++c) frame[c] = vector_in(nrrd.measurementFrame[c]);
  vtkNew<vtkDoubleArray> turned;
  turned->SetName("NRRD");
  turned->SetNumberOfComponents(3);
  turned->SetNumberOfTuples(vectors->GetNumberOfTuples());
  for (vtkIdType i = 0; i < vectors->GetNumberOfTuples(); ++i) {
    const glm::dvec3 v = signs * (frame * vector_in(vectors->GetTuple(i)));
    turned->SetTuple3(i, v.x, v.y, v.z);
  }
  image.GetPointData()->AddArray(turned);
}

vtkSmartPointer<vtkImageData> image_of(const Path& path) {
  OwnNrrd nrrd = load(path);
  const Axes axes = axes_of(*nrrd, path);
  const Placement placement =
      nrrd->spaceDim > 0 ? in_space(*nrrd, axes, path) : by_axes(*nrrd, axes);
  auto image = vtkSmartPointer<vtkImageData>::New();
  int size[3] = {1, 1, 1};
  for (std::size_t i = 0; i < axes.space.size(); ++i) size[i] = int(nrrd->axis[axes.space[i]].size);
  image->SetDimensions(size);
  const std::size_t components = axes.row ? nrrd->axis[*axes.row].size : 1;
  nrrd = with_rows_first(std::move(nrrd), axes, path);
  image->GetPointData()->AddArray(samples_of(*nrrd, components));
  turn_vectors(*image, *nrrd);
  place_image(*image, placement.steps, placement.origin, path.c_str());
  return image;
}

}  // namespace

vtkSmartPointer<vtkAlgorithm> make_nrrd(const Path& path) {
  if (const std::string pattern = numbered_files_of_nrrd(path); !pattern.empty())
    fail(path, fmt::format("data file: {}; accepted: one file, or LIST and their names", pattern));
  const auto producer = vtkSmartPointer<vtkTrivialProducer>::New();
  producer->SetOutput(image_of(path));
  return producer;
}

}  // namespace pellucid::readers
