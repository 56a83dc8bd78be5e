// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "compare/results/result_row.h"

namespace pellucid::compare {

/// A number of a study's tables. CSV, Markdown, LaTeX, the report's page, claims and `list` read
/// this one table; names, parameters and errors, which are texts, stand before and after it.
struct Column {
  std::string name;     // in CSV and study files: "seconds"
  std::string heading;  // for people, with the unit that `style` shows: "Time [ms]"
  std::string unit;     // of the value, as CSV has it: "s"
  Better better;
  NumberStyle style;
  bool in_tables;  // of those for people and papers: table.md, table.tex
  bool in_report;  // of the page's table of all numbers
  /// Nothing where a row, which has no error, lacks it.
  std::function<std::optional<double>(const ResultRow&)> value;
};

/// All columns in the order of results.csv.
std::span<const Column> columns();

/// Says whether `a` is the better number; false where no way is better.
bool is_better(const Column& column, double a, double b);

/// A value in few digits, in the unit that the style has: seconds as milliseconds, bytes as MB.
std::string number_for_people(NumberStyle style, double value);

/// The style's name, by which the report's page finds its own function: "milliseconds".
std::string_view name_of(NumberStyle style);

/// "lower", "higher" or "neither".
std::string_view name_of(Better better);

}  // namespace pellucid::compare
