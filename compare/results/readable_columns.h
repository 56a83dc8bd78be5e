// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "compare/results/result_row.h"

namespace pellucid::compare {

/// A column for people: its number, how it is written, and which way is better.
struct ReadableColumn {
  std::string_view name;   // in study files: "rmse"
  std::string_view title;  // unit included
  std::optional<double> (*value)(const ResultRow&);
  std::string (*text)(double);
  scene::Measure::Better better;
};

std::span<const ReadableColumn> readable_columns();

/// Whether `a` is the better number. False where no way is better.
bool is_better(const ReadableColumn& column, double a, double b);

}  // namespace pellucid::compare
