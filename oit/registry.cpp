#include "oit/registry.h"

#include <array>

#include "oit/methods/fourier.h"
#include "oit/methods/linked_list.h"
#include "oit/methods/weighted_average.h"
#include "oit/methods/weighted_blended.h"

namespace pellucid {

std::span<const MethodRow> oit_methods() {
  static const std::array rows = {linked_list_method(), weighted_average_method(),
                                  weighted_blended_method(), fourier_method()};
  return rows;
}

}  // namespace pellucid
