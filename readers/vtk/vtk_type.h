// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkType.h>

#include "core/files/blocks.h"

namespace pellucid::readers {

/// Returns VTK's constant of a type of numbers.
constexpr int vtk_type(NumberType type) {
  constexpr int types[] = {
      VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,     VTK_UNSIGNED_SHORT,
      VTK_INT,         VTK_UNSIGNED_INT,  VTK_LONG_LONG, VTK_UNSIGNED_LONG_LONG,
      VTK_FLOAT,       VTK_DOUBLE};
  return types[std::size_t(type)];
}

}  // namespace pellucid::readers
