// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/results/number_json.h"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

namespace pellucid::compare {
namespace {

constexpr const char* infinite = "inf";
constexpr const char* minus_infinite = "-inf";
constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

nlohmann::json number_json(std::optional<double> value) {
  if (!value || std::isnan(*value)) return nullptr;
  if (std::isinf(*value)) return *value > 0 ? infinite : minus_infinite;
  return *value;
}

std::optional<double> number_of(const nlohmann::json& json) {
  if (json.is_null()) return std::nullopt;
  if (json == infinite) return infinity;
  if (json == minus_infinite) return -infinity;
  return json.get<double>();
}

}  // namespace pellucid::compare
