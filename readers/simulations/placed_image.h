// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <glm/glm.hpp>

class vtkImageData;

namespace pellucid::readers {

/// Places the points of an image, which has no values of cells: `steps` lead from one to the next
/// along its axes, the first is at `origin`. Axes along those of space become these, ascending;
/// others turn the image. Throws InputError, after `file`, for a step without a positive length.
void place_image(vtkImageData& image, const std::array<glm::dvec3, 3>& steps,
                 const glm::dvec3& origin, const char* file);

}  // namespace pellucid::readers
