// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include "fields/files/meta_image.h"

namespace pellucid::fields {

/// Returns the image as VTK has it, its axes turned as the header says: an array of its points,
/// "velocity" where a sample has three numbers, else "MetaImage".
vtkSmartPointer<vtkImageData> data_set_of(const MetaImage& image);

}  // namespace pellucid::fields
