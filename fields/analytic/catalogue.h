// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "core/options/parameters.h"
#include "fields/field.h"

namespace pellucid::fields {

/// FlowFacts are what is known of an analytic flow; a property test holds every flow to it.
struct FlowFacts {
  std::string_view name;
  std::string_view title;
  std::string_view citation;  // or how it is derived
  std::string_view formula;
  bool steady = true;  // by default options
  bool divergence_free = false;
  Box3 region{Vec3(-1), Vec3(1)};  // where there is something to see
  bool bounded = false;            // samples exist in `region` alone
};

/// One row of the table of analytic flows that `list`, make_field and the tests read.
struct FieldRow : FlowFacts {
  std::span<const ParameterSpec> parameters;
  std::unique_ptr<VectorField> (*make)(const Parameters&);
};

/// Returns the table of the flows.
std::span<const FieldRow> analytic_fields();

}  // namespace pellucid::fields
