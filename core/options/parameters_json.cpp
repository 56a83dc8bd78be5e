// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/options/parameters_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/options/split.h"

namespace pellucid {
namespace {

std::string_view name_of(ParameterSpec::Kind kind) {
  switch (kind) {
    case ParameterSpec::Kind::integer:
      return "integer";
    case ParameterSpec::Kind::real:
      return "real";
    case ParameterSpec::Kind::choice:
      return "choice";
    case ParameterSpec::Kind::flag:
      return "flag";
    case ParameterSpec::Kind::text:
      return "text";
    case ParameterSpec::Kind::file:
      return "file";
  }
  return {};
}

nlohmann::ordered_json row_json(const ParameterSpec& spec) {
  nlohmann::ordered_json row{
      {"name", spec.name},           {"kind", name_of(spec.kind)}, {"default", spec.default_value},
      {"accepted", spec.accepted()}, {"unit", spec.unit},          {"help", spec.help}};
  if (std::isfinite(spec.min)) row["min"] = spec.min;
  if (std::isfinite(spec.max)) row["max"] = spec.max;
  if (spec.kind == ParameterSpec::Kind::choice) row["choices"] = split(spec.choices, '|');
  return row;
}

}  // namespace

nlohmann::ordered_json parameters_json(std::span<const ParameterSpec> parameters) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const ParameterSpec& spec : parameters) rows.push_back(row_json(spec));
  return rows;
}

}  // namespace pellucid
