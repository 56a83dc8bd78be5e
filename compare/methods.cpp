#include "compare/methods.h"

#include <vector>

#include "groundtruth/decoupled.h"
#include "groundtruth/march.h"
#include "groundtruth/raytrace.h"
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
