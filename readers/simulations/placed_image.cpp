// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/simulations/placed_image.h"

#include <fmt/format.h>
#include <vtkImageData.h>

#include <cmath>
#include <optional>

#include "core/error.h"
#include "readers/simulations/permuted_axes.h"
#include "readers/vtk/ascending_axes.h"

namespace pellucid::readers {
namespace {

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

void check_lengths(const Steps& steps, const char* file) {
  for (std::size_t a = 0; a < 3; ++a)
    if (const double length = glm::length(steps[a]); !std::isfinite(length) || length == 0)
      throw InputError(
          fmt::format("{}: a step along axis {} of its matrix is {} long; accepted: "
                      "a positive length",
                      file, a, length));
}

}  // namespace

void place_image(vtkImageData& image, const Steps& steps, const glm::dvec3& origin,
                 const char* file) {
  check_lengths(steps, file);
  const auto axes = axes_along(steps);
  double spacing[3], direction[9];
  for (std::size_t a = 0; a < 3; ++a) {
    spacing[a] = axes ? steps[a][(*axes)[a]] : glm::length(steps[a]);
    for (std::size_t row = 0; row < 3; ++row)
      direction[3 * row + a] = steps[a][int(row)] / glm::length(steps[a]);
  }
  image.SetSpacing(spacing);
  image.SetOrigin(origin.x, origin.y, origin.z);
  if (axes)
    permute_axes(image, *axes);
  else
    image.SetDirectionMatrix(direction);
  make_axes_ascend(image);
}

}  // namespace pellucid::readers
