// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compare/results/columns.h"
#include "compare/results/result_row.h"

namespace pellucid::compare {

/// Every measure that some row has, once, in the order of its first row; values are that row's.
std::vector<scene::Measure> measure_columns(std::span<const ResultRow> rows);

/// Nothing where the row has no such measure.
std::optional<double> measure_of(const ResultRow& row, std::string_view name);

/// Returns whether the measure tells of time: in seconds, or which step took longest. It is another
/// one in every run.
bool is_of_time(const scene::Measure& measure);

/// Returns where the row's measure lies, itself where it has no noise; nothing of one that is of
/// time, of which only one number is kept, but that a step took longest where the intervals of all
/// others lie below.
std::optional<Interval> interval_of_measure(const ResultRow& row, std::string_view name);

/// Returns over how many views the rows' numbers are means: the most of them, 1 where none has
/// views.
int views_of(std::span<const ResultRow> rows);

/// Returns the column of this name: one of columns(), or a measure that some row has, the worst of
/// a metric over views written as the metric is. Throws InputError that lists the known names.
Column column_named(std::string_view name, std::span<const ResultRow> rows);

/// "Integration [s]".
std::string heading(const scene::Measure& measure);

}  // namespace pellucid::compare
