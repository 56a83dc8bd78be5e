// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/report/column_json.h"

#include <nlohmann/json.hpp>

namespace pellucid::compare {

nlohmann::json column_json(const Column& column) {
  return {{"name", column.name},
          {"title", column.title},
          {"heading", heading(column)},
          {"style", name_of(column.style)},
          {"unit", unit_for_people(column.style)},
          {"factor", in_unit_for_people(column.style, 1)},
          {"better", name_of(column.better)},
          {"card", column.shown.card},
          {"sweeps", column.shown.sweeps},
          {"timed", is_time(column)},
          {"role", name_of(column.shown.role)}};
}

}  // namespace pellucid::compare
