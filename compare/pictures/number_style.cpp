// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/pictures/number_style.h"

#include <fmt/format.h>

#include <cmath>

#include "core/options/names.h"

namespace pellucid::compare {
namespace {

struct BetterRow {
  Better better;
  std::string_view name;
};

constexpr BetterRow directions[] = {
    {Better::lower, "lower"}, {Better::higher, "higher"}, {Better::neither, "neither"}};

struct StyleRow {
  NumberStyle style;
  std::string_view name;
  std::string_view unit;          // for people
  double (*in_unit)(double);      // from the column's own unit
  std::string (*digits)(double);  // of the value in the unit for people
};

double as_it_is(double x) { return x; }
std::string scientific(double x) { return x == 0 ? "0" : fmt::format("{:.2e}", x); }
/// Four decimals; 1 is equality alone.
std::string similarity(double x) {
  if (x == 1) return "1";
  return x > 0.99995 ? ">0.9999" : fmt::format("{:.4f}", x);
}
std::string one_decimal(double x) { return std::isinf(x) ? "∞" : fmt::format("{:.1f}", x); }
/// One decimal; two digits of what is less than 1, so that nothing that is there is 0.0.
std::string cost(double x) {
  return x != 0 && std::abs(x) < 1 ? fmt::format("{:#.2g}", x) : one_decimal(x);
}
std::string whole(double x) { return fmt::format("{:.0f}", x); }

constexpr StyleRow styles[] = {
    {NumberStyle::scientific, "scientific", "", as_it_is, scientific},
    {NumberStyle::similarity, "similarity", "", as_it_is, similarity},
    {NumberStyle::decibels, "decibels", "dB", as_it_is, one_decimal},
    {NumberStyle::milliseconds, "milliseconds", "ms", [](double s) { return s * 1e3; }, cost},
    {NumberStyle::megabytes, "megabytes", "MB", [](double bytes) { return bytes / 1e6; }, cost},
    {NumberStyle::count, "count", "", as_it_is, whole},
    {NumberStyle::plain_milliseconds, "plain_milliseconds", "ms", as_it_is, cost}};

const StyleRow& row_of(NumberStyle style) { return styles[std::size_t(style)]; }

}  // namespace

std::string_view name_of(Better better) { return directions[std::size_t(better)].name; }

Better better_of_name(std::string_view name) {
  return find_row("direction", name, directions).better;
}

std::string_view name_of(NumberStyle style) { return row_of(style).name; }

std::string_view unit_for_people(NumberStyle style) { return row_of(style).unit; }

double in_unit_for_people(NumberStyle style, double value) { return row_of(style).in_unit(value); }

std::string number_for_people(NumberStyle style, double value) {
  return row_of(style).digits(in_unit_for_people(style, value));
}

std::string heading(std::string_view title, NumberStyle style) {
  const std::string_view unit = unit_for_people(style);
  return unit.empty() ? std::string(title) : fmt::format("{} [{}]", title, unit);
}

std::string_view name_of(TradeOff role) {
  constexpr std::string_view names[] = {"none", "error", "cost"};
  return names[std::size_t(role)];
}

}  // namespace pellucid::compare
