// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/files/meta_image_data.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <cstring>

#include "readers/vtk/vtk_type.h"

namespace pellucid::fields {

vtkSmartPointer<vtkImageData> data_set_of(const MetaImage& image) {
  const MetaImageHeader& header = image.header;
  const auto data = vtkSmartPointer<vtkImageData>::New();
  data->SetDimensions(int(header.size[0]), int(header.size[1]), int(header.size[2]));
  data->SetOrigin(header.origin.x, header.origin.y, header.origin.z);
  data->SetSpacing(header.spacing.x, header.spacing.y, header.spacing.z);
  if (header.directions) {
    double rows[9];
    for (int a = 0; a < 3; ++a)
      for (int row = 0; row < 3; ++row) rows[3 * row + a] = (*header.directions)[a][row];
    data->SetDirectionMatrix(rows);
  }
  vtkSmartPointer<vtkDataArray> array;
  array.TakeReference(vtkDataArray::CreateDataArray(readers::vtk_type(header.type)));
  array->SetName(header.channels == 3 ? "velocity" : "MetaImage");
  array->SetNumberOfComponents(int(header.channels));
  array->SetNumberOfTuples(vtkIdType(header.samples()));
  std::memcpy(array->GetVoidPointer(0), image.bytes.data(), image.bytes.size());
  data->GetPointData()->AddArray(array);
  return data;
}

}  // namespace pellucid::fields
