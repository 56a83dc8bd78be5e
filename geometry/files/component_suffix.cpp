// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/files/component_suffix.h"

#include <fmt/format.h>

namespace pellucid::geometry {

std::string component_suffix(std::size_t component, std::size_t components) {
  static constexpr const char* of_vector[] = {"_x", "_y", "_z", "_w"};
  static constexpr const char* of_symmetric[] = {"_xx", "_yy", "_zz", "_xy", "_yz", "_xz"};
  static constexpr const char* of_tensor[] = {"_xx", "_xy", "_xz", "_yx", "_yy",
                                              "_yz", "_zx", "_zy", "_zz"};
  if (components <= 4) return of_vector[component];
  if (components == 6) return of_symmetric[component];
  if (components == 9) return of_tensor[component];
  return fmt::format("_{}", component);
}

}  // namespace pellucid::geometry
