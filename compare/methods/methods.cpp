#include "compare/methods/methods.h"

#include <vector>

#include "groundtruth/methods/decoupled.h"
#include "groundtruth/methods/march.h"
#include "groundtruth/methods/raytrace.h"
#include "oit/registry.h"

namespace pellucid {

std::span<const MethodRow> methods() {
  static const std::vector<MethodRow> table = [] {
    std::vector<MethodRow> rows{raytrace_method(), march_method(), decoupled_method()};
    rows.insert(rows.end(), oit_methods().begin(), oit_methods().end());
    return rows;
  }();
  return table;
}

}  // namespace pellucid
