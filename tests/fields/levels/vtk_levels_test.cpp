// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/levels/vtk_levels.h"

#include <gtest/gtest.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>

namespace pellucid::fields {
namespace {

float number(vtkIdType i) { return float(1 + i % 9'999'991); }  // no zeros, all exact

/// 17 million numbers: so many that pages go back twice while they are copied.
vtkSmartPointer<vtkImageData> large_image() {
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(400, 250, 170);
  vtkNew<vtkFloatArray> numbers;
  numbers->SetName("p");
  numbers->SetNumberOfTuples(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < numbers->GetNumberOfTuples(); ++i) numbers->SetValue(i, number(i));
  image->GetPointData()->AddArray(numbers);
  return image;
}

/// Whether all of an image's numbers came.
bool all_came(vtkImageData& image) {
  const auto levels = std::get<std::vector<ScalarLevel>>(level_of(image, "p.vti", "p"));
  vtkIdType i = 0;
  return levels.size() == 1 && levels[0].samples.size() == 17'000'000 &&
         std::ranges::all_of(levels[0].samples,
                             [&](float sample) { return sample == number(i++); });
}

std::size_t zeros_in(vtkFloatArray& array) {
  const float* numbers = array.GetPointer(0);
  return std::size_t(std::count(numbers, numbers + array.GetNumberOfValues(), 0.f));
}

TEST(UnitVtkLevels, ALargeScalarIsInMemoryOnce) {
  const auto image = large_image();
  EXPECT_TRUE(all_came(*image));
  EXPECT_GE(zeros_in(*vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray("p"))),
            16'000'000u);
}

TEST(UnitVtkLevels, WhatSomethingElseHasIsKept) {
  const auto image = large_image();
  const vtkSmartPointer<vtkFloatArray> kept =
      vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray("p"));
  EXPECT_TRUE(all_came(*image));
  EXPECT_EQ(zeros_in(*kept), 0u);
  EXPECT_TRUE(all_came(*image));
}

}  // namespace
}  // namespace pellucid::fields
