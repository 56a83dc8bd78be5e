// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "scene/renderer.h"

namespace pellucid::compare {

/// A Better says which way a number is better.
using Better = scene::Measure::Better;

/// Returns "lower", "higher" or "neither".
std::string_view name_of(Better better);

/// Returns the Better of that name. Throws InputError for another one.
Better better_of_name(std::string_view name);

/// A NumberStyle says how a number is written for people: `milliseconds` is of seconds,
/// `plain_milliseconds` of milliseconds.
enum class NumberStyle {
  scientific,
  similarity,
  decibels,
  milliseconds,
  megabytes,
  count,
  plain_milliseconds
};

/// Returns the style's name, by which the report's page finds its own function: "milliseconds".
std::string_view name_of(NumberStyle style);

/// Returns the unit in which people read the number: "ms" where the value is in seconds. Empty: a
/// plain number.
std::string_view unit_for_people(NumberStyle style);

/// Returns the value in that unit: 3 for 0.003 s.
double in_unit_for_people(NumberStyle style, double value);

/// Returns the value in few digits, in the unit for people.
std::string number_for_people(NumberStyle style, double value);

/// Returns the title with the unit for people: "Time [ms]".
std::string heading(std::string_view title, NumberStyle style);

/// A TradeOff says what a number is in the report's plots of error against cost.
enum class TradeOff { none, error, cost };

/// Returns "none", "error" or "cost".
std::string_view name_of(TradeOff role);

/// A Shown says where a number appears beside results.csv and claims, which have all of them.
struct Shown {
  bool tables = false;  // those for people and papers: table.md, table.tex
  bool report = false;  // the page's table of all numbers, whence the other parts take it
  bool card = false;    // below each picture of the page
  bool sweeps = false;  // over the parameter that a study sweeps
  TradeOff role = TradeOff::none;
};

}  // namespace pellucid::compare
