// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "compare/results/result_row.h"

namespace pellucid::compare {

/// A Column is a number of a study's tables. CSV, Markdown, LaTeX, the report's page, claims and
/// `list` read this one table; names, parameters and errors, which are texts, stand before and
/// after it.
struct Column {
  std::string name;   // in CSV and study files: "seconds"
  std::string title;  // for people: "Time"
  std::string unit;   // of the value, as CSV has it: "s"
  Better better;
  NumberStyle style;
  Shown shown;
  /// Nothing where a row, which has no error, lacks it.
  std::function<std::optional<double>(const ResultRow&)> value;
  /// The interval of the value, in its unit; nothing where a row has none, as errors of all methods
  /// but those of random numbers; null where no row has one.
  std::function<std::optional<Interval>(const ResultRow&)> interval = nullptr;
};

/// All columns in the order of results.csv.
std::span<const Column> columns();

/// Returns the median time of a row in seconds; nothing where nobody told it, as of a picture from
/// elsewhere.
std::optional<double> known_seconds(const ResultRow& row);

/// Says whether `a` is the better number; false where no way is better.
bool is_better(const Column& column, double a, double b);

/// Says whether the numbers are times, which are not the same twice.
bool is_time(const Column& column);

/// Returns the interval of a row's number; nothing where it has none.
std::optional<Interval> interval_of(const Column& column, const ResultRow& row);

/// Returns where a row's number lies: its interval, or itself where it has none; nothing of a time
/// without one.
std::optional<Interval> place_of(const Column& column, const ResultRow& row);

/// Returns the number for people, with its interval where it has one: "12.5 (12.1–13.0)".
std::string text_with_interval(const Column& column, const ResultRow& row);

/// Says whether an interval of one of two rows leaves open which of their numbers is the better
/// one: their places overlap.
bool are_tied(const Column& column, const ResultRow& a, const ResultRow& b);

/// The title with the unit in which people read the number: "Time [ms]".
std::string heading(const Column& column);

}  // namespace pellucid::compare
