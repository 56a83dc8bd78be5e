// SPDX-License-Identifier: GPL-3.0-or-later
// VTK's reader leaves it to its caller to rescale and to put voxels where the file's matrix has
// them, reverses slices where that matrix is left-handed, and takes the first of several times in
// silence. Meanings of the header's numbers: nifti1.h, "DATA SCALING" and "3D IMAGE (VOLUME)
// ORIENTATION AND LOCATION IN SPACE".

#include "readers/simulations/make_nifti.h"

#include <fmt/format.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkMatrix4x4.h>
#include <vtkNIFTIImageReader.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>

#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <optional>

#include "core/error.h"
#include "readers/simulations/permuted_axes.h"
#include "readers/vtk/ascending_axes.h"

namespace pellucid::readers {
namespace {

/// 24 bits hold numbers of 16 and what scales them; others need more.
bool fits_float(int type) {
  return type == VTK_FLOAT || type == VTK_CHAR || type == VTK_SIGNED_CHAR ||
         type == VTK_UNSIGNED_CHAR || type == VTK_SHORT || type == VTK_UNSIGNED_SHORT;
}

vtkSmartPointer<vtkDataArray> rescaled(vtkDataArray& array, double slope, double intercept) {
  vtkSmartPointer<vtkDataArray> result;
  if (fits_float(array.GetDataType()))
    result = vtkSmartPointer<vtkFloatArray>::New();
  else
    result = vtkSmartPointer<vtkDoubleArray>::New();
  result->SetName(array.GetName());
  result->SetNumberOfComponents(array.GetNumberOfComponents());
  result->SetNumberOfTuples(array.GetNumberOfTuples());
  for (vtkIdType i = 0; i < array.GetNumberOfTuples(); ++i)
    for (int c = 0; c < array.GetNumberOfComponents(); ++c)
      result->SetComponent(i, c, array.GetComponent(i, c) * slope + intercept);
  return result;
}

/// From one voxel to the next along axis `a`, in the file's space.
glm::dvec3 step_along(int a, vtkMatrix4x4& world_from_mm, const double* spacing) {
  return glm::dvec3(world_from_mm.GetElement(0, a), world_from_mm.GetElement(1, a),
                    world_from_mm.GetElement(2, a)) *
         spacing[a];
}

using Steps = std::array<glm::dvec3, 3>;

/// Which axis of space each step runs along, where all do: within what quaternions of floats leave.
std::optional<std::array<int, 3>> axes_along(const Steps& steps) {
  constexpr double rounding = 1e-6;
  std::array<int, 3> axes{};
  glm::bvec3 taken(false);
  for (std::size_t a = 0; a < 3; ++a) {
    const glm::dvec3 size = glm::abs(steps[a]);
    axes[a] = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    glm::dvec3 across = steps[a];
    across[axes[a]] = 0;
    if (glm::length(across) > rounding * glm::length(steps[a]) || taken[axes[a]])
      return std::nullopt;
    taken[axes[a]] = true;
  }
  return axes;
}

Steps steps_of(vtkMatrix4x4& world_from_mm, const double* spacing, const char* file) {
  Steps steps;
  for (int a = 0; a < 3; ++a) {
    steps[std::size_t(a)] = step_along(a, world_from_mm, spacing);
    const double length = glm::length(steps[std::size_t(a)]);
    if (!std::isfinite(length) || length == 0)
      throw InputError(
          fmt::format("{}: a step along axis {} of its matrix is {} long; accepted: "
                      "a positive length",
                      file, a, length));
  }
  return steps;
}

/// Places the voxels, the first of which VTK has at 0: `world_from_mm` takes VTK's positions into
/// the file's space, slices reversed or not. Axes along those of space become these; others turn
/// the image.
void place(vtkImageData& image, vtkMatrix4x4& world_from_mm, const char* file) {
  const Steps steps = steps_of(world_from_mm, image.GetSpacing(), file);
  const auto axes = axes_along(steps);
  double spacing[3], direction[9];
  for (std::size_t a = 0; a < 3; ++a) {
    spacing[a] = axes ? steps[a][(*axes)[a]] : glm::length(steps[a]);
    for (std::size_t row = 0; row < 3; ++row)
      direction[3 * row + a] = steps[a][int(row)] / glm::length(steps[a]);
  }
  image.SetSpacing(spacing);
  image.SetOrigin(world_from_mm.GetElement(0, 3), world_from_mm.GetElement(1, 3),
                  world_from_mm.GetElement(2, 3));
  if (axes)
    permute_axes(image, *axes);
  else
    image.SetDirectionMatrix(direction);
  make_axes_ascend(image);
}

class NiftiReader : public vtkNIFTIImageReader {
 public:
  static NiftiReader* New() { VTK_STANDARD_NEW_BODY(NiftiReader); }

 protected:
  /// Without VTK's warning of a qform and an sform of different hands, of which place() takes one.
  /// An error is met again.
  int RequestInformation(vtkInformation* request, vtkInformationVector** input,
                         vtkInformationVector* output) override {
    const int shown = GetGlobalWarningDisplay();
    SetGlobalWarningDisplay(0);
    const int done = vtkNIFTIImageReader::RequestInformation(request, input, output);
    SetGlobalWarningDisplay(shown);
    return done ? done : vtkNIFTIImageReader::RequestInformation(request, input, output);
  }

  int RequestData(vtkInformation* request, vtkInformationVector** input,
                  vtkInformationVector* output) override {
    refuse_times();
    if (!vtkNIFTIImageReader::RequestData(request, input, output)) return 0;
    vtkImageData* image = vtkImageData::GetData(output);
    if (vtkDataArray* array = image->GetPointData()->GetScalars(); array && is_scaled())
      image->GetPointData()->SetScalars(rescaled(*array, slope(), GetRescaleIntercept()));
    if (vtkMatrix4x4* world_from_mm = matrix()) place(*image, *world_from_mm, GetFileName());
    return 1;
  }

 private:
  vtkMatrix4x4* matrix() { return GetSFormMatrix() ? GetSFormMatrix() : GetQFormMatrix(); }
  double slope() { return GetRescaleSlope(); }
  bool is_scaled() {
    if (!std::isfinite(slope()) || slope() == 0) return false;
    if (!std::isfinite(GetRescaleIntercept()))
      throw InputError(fmt::format("{}: scl_inter is {}; accepted: a number", GetFileName(),
                                   GetRescaleIntercept()));
    return slope() != 1 || GetRescaleIntercept() != 0;
  }
  void refuse_times() {
    if (GetTimeDimension() > 1)
      throw InputError(
          fmt::format("{}: {} volumes over time; accepted: one, of one number per "
                      "voxel or of vectors along the fifth dimension",
                      GetFileName(), GetTimeDimension()));
  }
};

}  // namespace

vtkSmartPointer<vtkAlgorithm> make_nifti(const std::filesystem::path& path) {
  const auto reader = vtkSmartPointer<NiftiReader>::New();
  reader->SetFileName(path.c_str());
  return reader;
}

}  // namespace pellucid::readers
