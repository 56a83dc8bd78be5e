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
#include <vtkNIFTIImageHeader.h>
#include <vtkNIFTIImageReader.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>

#include <array>
#include <cmath>
#include <glm/glm.hpp>

#include "core/error.h"
#include "readers/simulations/placed_image.h"

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

/// `world_from_mm` takes VTK's positions into the file's space, slices reversed or not; VTK has the
/// first voxel at 0.
void place(vtkImageData& image, vtkMatrix4x4& world_from_mm, const char* file) {
  std::array<glm::dvec3, 3> steps;
  for (int a = 0; a < 3; ++a)
    steps[std::size_t(a)] = step_along(a, world_from_mm, image.GetSpacing());
  place_image(image, steps,
              {world_from_mm.GetElement(0, 3), world_from_mm.GetElement(1, 3),
               world_from_mm.GetElement(2, 3)},
              file);
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
    refuse_more_volumes();
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
  void refuse_more_volumes() {
    if (GetTimeDimension() > 1)
      throw InputError(
          fmt::format("{}: {} volumes over time; accepted: one, of one number per "
                      "voxel or of vectors along the fifth dimension",
                      GetFileName(), GetTimeDimension()));
    // VTK takes the first of those, too, in silence; CIFTI has its matrices there.
    for (int axis = 6; axis <= GetNIFTIHeader()->GetDim(0); ++axis)
      if (const auto count = GetNIFTIHeader()->GetDim(axis); count > 1)
        throw InputError(fmt::format("{}: dim[{}] is {}; accepted: 1 (five dimensions at most)",
                                     GetFileName(), axis, count));
  }
};

}  // namespace

vtkSmartPointer<vtkAlgorithm> make_nifti(const std::filesystem::path& path) {
  const auto reader = vtkSmartPointer<NiftiReader>::New();
  reader->SetFileName(path.c_str());
  return reader;
}

}  // namespace pellucid::readers
