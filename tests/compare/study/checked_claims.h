// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "compare/study/claims.h"
#include "core/options/names.h"
#include "tests/compare/study/result_rows.h"

namespace pellucid::compare {

inline const std::vector<std::string> scenes{"one", "two"};
inline const std::vector<ResultRow> rows{row("one", "a", 0.1),  row("one", "b", 0.2),
                                         row("one", "c", 0.3),  row("two", "a", 0.4),
                                         row("two", "b", 0.25), row("two", "c", 0.5)};

/// A claim that the calls are in this order, by a column.
inline Claim claim(const char* by, std::vector<std::vector<std::string>> order) {
  const Column& column = find_row("number", by, columns());
  return {"", {&column, {}, column.better}, std::move(order)};
}

/// How a claim stands on scene one.
inline std::string verdict_of(const Claim& claim, const std::vector<ResultRow>& measured) {
  const auto checks = check_claim(claim, std::vector<std::string>{"one"}, measured);
  return checks.size() == 1 ? verdict(checks[0]) : "no check";
}

}  // namespace pellucid::compare
