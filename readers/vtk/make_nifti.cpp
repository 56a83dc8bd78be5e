// SPDX-License-Identifier: GPL-3.0-or-later
// VTK's reader leaves it to its caller to rescale, and takes the first of several times in silence.
// Meanings of the header's numbers: nifti1.h, "DATA SCALING".

#include "readers/vtk/make_nifti.h"

#include <fmt/format.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkNIFTIImageReader.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>

#include <cmath>

#include "core/error.h"

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

class NiftiReader : public vtkNIFTIImageReader {
 public:
  static NiftiReader* New() { VTK_STANDARD_NEW_BODY(NiftiReader); }

 protected:
  int RequestData(vtkInformation* request, vtkInformationVector** input,
                  vtkInformationVector* output) override {
    refuse_times();
    if (!vtkNIFTIImageReader::RequestData(request, input, output)) return 0;
    vtkImageData* image = vtkImageData::GetData(output);
    if (vtkDataArray* array = image->GetPointData()->GetScalars(); array && is_scaled())
      image->GetPointData()->SetScalars(rescaled(*array, slope(), GetRescaleIntercept()));
    return 1;
  }

 private:
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
