// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A field's samples on a grid, for VTK's filters and, by a file, for our own.

#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkXMLImageDataWriter.h>

#include <filesystem>
#include <memory>

#include "fields/make_field.h"

namespace pellucid::benchmarks {

inline vtkNew<vtkImageData> samples_of(const fields::VectorField& field, const Box3& box, int n) {
  vtkNew<vtkImageData> image;
  image->SetDimensions(n, n, n);
  image->SetOrigin(box.min.x, box.min.y, box.min.z);
  const Vec3 size = box.max - box.min;
  image->SetSpacing(size.x / (n - 1), size.y / (n - 1), size.z / (n - 1));
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("velocity");
  vectors->SetNumberOfComponents(3);
  const auto sampler = field.sampler();
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i) {
    double x[3];
    image->GetPoint(i, x);
    Vec3 v;
    sampler->velocity({x[0], x[1], x[2]}, 0, v);
    vectors->InsertNextTuple3(v.x, v.y, v.z);
  }
  image->GetPointData()->SetVectors(vectors);
  return image;
}

/// The field's samples at n³ points of the box, trilinear between them.
inline std::unique_ptr<fields::VectorField> sampled(const fields::VectorField& field,
                                                    const Box3& box, int n) {
  const auto path = std::filesystem::temp_directory_path() / "pellucid_bench.vti";
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(samples_of(field, box, n));
  writer->Write();
  auto samples = fields::make_field(path.string());
  std::filesystem::remove(path);
  return samples;
}

}  // namespace pellucid::benchmarks
