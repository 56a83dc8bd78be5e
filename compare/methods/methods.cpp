// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/methods/methods.h"

#include <vector>

#include "core/options/names.h"
#include "groundtruth/methods/decoupled.h"
#include "groundtruth/methods/march.h"
#include "groundtruth/methods/raytrace.h"
#include "oit/methods/written/glsl_method.h"
#include "oit/registry.h"

namespace pellucid::compare {

std::span<const scene::MethodRow> methods() {
  static const std::vector<scene::MethodRow> table = [] {
    std::vector<scene::MethodRow> rows{groundtruth::raytrace_method(), groundtruth::march_method(),
                                       groundtruth::decoupled_method()};
    rows.insert(rows.end(), oit::oit_methods().begin(), oit::oit_methods().end());
    return rows;
  }();
  return table;
}

std::span<const scene::MethodRow> callable_methods() {
  static const std::vector<scene::MethodRow> table = [] {
    std::vector<scene::MethodRow> rows(methods().begin(), methods().end());
    rows.push_back(oit::glsl_method());
    return rows;
  }();
  return table;
}

MethodCall parse_call(std::string_view text, std::span<const scene::MethodRow> rows) {
  const NameAndOptions named = parse_name_and_options(text);
  const scene::MethodRow& row = find_row("method", named.name, rows);
  return {&row, Parameters(row.name, row.parameters, named.options)};
}

}  // namespace pellucid::compare
