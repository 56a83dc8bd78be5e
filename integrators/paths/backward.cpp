// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/paths/backward.h"

#include "fields/reversed_field.h"

namespace pellucid::integrators {

std::shared_ptr<const fields::VectorField> reversed_view(const fields::VectorField& field,
                                                         double start_time) {
  return fields::reversed({std::shared_ptr<void>(), &field}, start_time);
}

void turn_back(geometry::Vertices& vertices, const fields::VectorField& field) {
  const auto start = fields::start_of_reversed(field);
  if (!start) return;
  if (const auto t = vertices.scalars.find("t"); t != vertices.scalars.end())
    for (double& value : t->second) value = 0 - value;
  for (const char* name : {"time", "released"})
    if (const auto time = vertices.scalars.find(name); time != vertices.scalars.end())
      for (double& value : time->second) value = *start - (value - *start);
}

}  // namespace pellucid::integrators
