// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/study/claims.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "compare/results/measure_columns.h"

namespace pellucid::compare {
namespace {

constexpr std::string_view needs_five =
    "has no interval, as of a time that was taken less than five times";

/// Nothing where the stage does not apply.
std::optional<double> share_of_stage(const ResultRow& row, std::string_view stage) {
  if (!row.budget) return std::nullopt;
  if (stage == interaction_name) return row.budget->interaction;
  const auto line = std::ranges::find(row.budget->lines, stage, &BudgetLine::stage);
  if (line == row.budget->lines.end() || !line->why_not.empty()) return std::nullopt;
  return line->share;
}

std::optional<ClaimedValue> value_of(const ClaimedNumber& number, std::string_view scene,
                                     std::string_view call, std::span<const ResultRow> rows) {
  for (const ResultRow& row : rows) {
    if (!row.error.empty() || row.scene != scene || row.call() != call) continue;
    if (const std::optional<double> value = number.of(row))
      return ClaimedValue{"", *value, number.interval_of(row)};
  }
  return std::nullopt;
}

bool is_better(Better way, double a, double b) { return way == Better::lower ? a < b : a > b; }

/// The end of an interval that is better, or worse.
double better_end(Better way, const Interval& i) { return way == Better::lower ? i.low : i.high; }
double worse_end(Better way, const Interval& i) { return way == Better::lower ? i.high : i.low; }

/// How many times as good `a` is as `b`: once as good where both are 0, or infinite.
double factor_of(Better way, double a, double b) {
  if (a == b) return 1;
  return way == Better::lower ? b / a : a / b;
}

std::string interval_text(const ClaimedNumber& number, const Interval& interval) {
  return fmt::format("{}–{}", number.text(interval.low), number.text(interval.high));
}

/// Returns whether one of the two has no interval, and says so: nothing is decided then.
bool lack_intervals(const ClaimedValue& a, const ClaimedValue& b, ClaimCheck& check) {
  for (const ClaimedValue* value : {&a, &b}) {
    if (value->interval) continue;
    std::string words = fmt::format("{} {}", value->of, needs_five);
    if (std::ranges::find(check.undecided, words) == check.undecided.end())
      check.undecided.push_back(std::move(words));
  }
  return !a.interval || !b.interval;
}

std::string both_intervals(const Claim& claim, const ClaimedValue& a, const ClaimedValue& b) {
  return fmt::format("({}, {})", interval_text(claim.by, *a.interval),
                     interval_text(claim.by, *b.interval));
}

/// Equal numbers are in any order.
void check_pair(const Claim& claim, const ClaimedValue& better, const ClaimedValue& worse,
                ClaimCheck& check) {
  const Better way = claim.by.better;
  const Interval a = *better.interval, b = *worse.interval;
  if (is_better(way, worse_end(way, b), better_end(way, a)))
    check.against.push_back(fmt::format("{} before {}", worse.of, better.of));
  else if (is_better(way, better_end(way, b), worse_end(way, a)))
    check.undecided.push_back(fmt::format("{} and {} are tied {}", better.of, worse.of,
                                          both_intervals(claim, better, worse)));
}

void check_factor(const Claim& claim, const ClaimedValue& better, const ClaimedValue& worse,
                  ClaimCheck& check) {
  const Better way = claim.by.better;
  const Interval a = *better.interval, b = *worse.interval;
  if (a.low < 0 || b.low < 0) {  // as a stage's share, or SSIM, may be
    check.undecided.push_back(
        fmt::format("{} and {} are not both above 0, so that no factor is "
                    "between them",
                    better.of, worse.of));
    return;
  }
  const double most = factor_of(way, better_end(way, a), worse_end(way, b));
  const double least = factor_of(way, worse_end(way, a), better_end(way, b));
  if (most < claim.factor)
    check.against.push_back(fmt::format("{} before {} by a factor of {:.3g}, not {:.3g}", better.of,
                                        worse.of, factor_of(way, better.value, worse.value),
                                        claim.factor));
  else if (!(least >= claim.factor))
    check.undecided.push_back(
        fmt::format("{} before {} by a factor of {:.3g} to {:.3g}, around {:.3g}", better.of,
                    worse.of, least, most, claim.factor));
}

/// Holds the values, which follow the claimed order in groups of these sizes, against it.
void check_order(const Claim& claim, std::span<const std::size_t> groups, ClaimCheck& check) {
  const auto check_two = claim.factor == 1 ? check_pair : check_factor;
  std::size_t group_end = 0;
  for (const std::size_t size : groups) {
    const std::size_t group_begin = group_end;
    group_end += size;
    for (std::size_t better = group_begin; better < group_end; ++better)
      for (std::size_t worse = group_end; worse < check.values.size(); ++worse)
        if (const auto& a = check.values[better], &b = check.values[worse];
            !lack_intervals(a, b, check))
          check_two(claim, a, b, check);
  }
}

/// Of what gets better from one to the next some may be equal, but not all.
void check_change(ClaimCheck& check) {
  const auto& first = check.values.front().interval;
  const bool is_one = std::ranges::all_of(check.values, [&](const ClaimedValue& value) {
    return first && value.interval && value.interval->low == first->low &&
           value.interval->high == first->high;
  });
  if (is_one) check.against.push_back("it does not change");
}

/// The value that is not the bound, in digits that tell the two apart.
std::string not_bound(const Claim& claim, double value) {
  const std::string here = claim.by.text(value), claimed = claim.by.text(*claim.bound);
  return here == claimed ? fmt::format("{}, not {}", value, *claim.bound)
                         : fmt::format("{}, not {}", here, claimed);
}

void check_bound(const Claim& claim, ClaimCheck& check) {
  const Better way = claim.by.better;
  for (const ClaimedValue& value : check.values) {
    if (lack_intervals(value, value, check)) continue;
    const std::string of = check.values.size() > 1 ? value.of + " " : "";
    if (is_better(way, *claim.bound, better_end(way, *value.interval)))
      check.against.push_back(of + not_bound(claim, value.value));
    else if (is_better(way, *claim.bound, worse_end(way, *value.interval)))
      check.undecided.push_back(fmt::format("{}{} is around {}", of,
                                            interval_text(claim.by, *value.interval),
                                            claim.by.text(*claim.bound)));
  }
}

/// A printed number stands for all that is rounded to it: those within half a unit of its last
/// digit.
void check_printed(const Claim& claim, ClaimCheck& check) {
  const double least = *claim.bound - *claim.within, most = *claim.bound + *claim.within;
  for (const ClaimedValue& value : check.values) {
    if (lack_intervals(value, value, check)) continue;
    const std::string of = check.values.size() > 1 ? value.of + " " : "";
    const auto [low, high] = *value.interval;
    if (high < least || low > most)
      check.against.push_back(of + not_bound(claim, value.value));
    else if (low < least || high > most)
      check.undecided.push_back(fmt::format("{}{} is around {}", of,
                                            interval_text(claim.by, *value.interval),
                                            claim.by.text(*claim.bound)));
  }
}

/// Whether `more` is greater than `less` by more than this part of the one that is nearer to 0.
bool is_more(double more, double less, double within) {
  return more - less > within * std::min(std::abs(more), std::abs(less));
}

/// Without a width two numbers are the same where their intervals overlap. With one the interval of
/// their ratio has to lie within it; where it lies outside they are not.
void check_same_pair(const Claim& claim, const ClaimedValue& a, const ClaimedValue& b,
                     ClaimCheck& check) {
  const auto [low_a, high_a] = *a.interval;
  const auto [low_b, high_b] = *b.interval;
  const double within = claim.within.value_or(0);
  const bool apart = claim.within ? is_more(low_a, high_b, within) || is_more(low_b, high_a, within)
                                  : !overlap(*a.interval, *b.interval);
  const bool together =
      !claim.within || (!is_more(high_a, low_b, within) && !is_more(high_b, low_a, within));
  if (apart)
    check.against.push_back(
        fmt::format("{} and {} differ {}", a.of, b.of, both_intervals(claim, a, b)));
  else if (!together)
    check.undecided.push_back(
        fmt::format("{} and {} may differ {}", a.of, b.of, both_intervals(claim, a, b)));
}

void check_same(const Claim& claim, ClaimCheck& check) {
  for (std::size_t i = 0; i < check.values.size(); ++i)
    for (std::size_t j = i + 1; j < check.values.size(); ++j)
      if (const auto& a = check.values[i], &b = check.values[j]; !lack_intervals(a, b, check))
        check_same_pair(claim, a, b, check);
}

void hold_against(const Claim& claim, ClaimCheck& check) {
  if (claim.bound) return claim.same ? check_printed(claim, check) : check_bound(claim, check);
  if (claim.same) return check_same(claim, check);
  std::vector<std::size_t> groups;
  for (const auto& group : claim.order) groups.push_back(group.size());
  check_order(claim, groups, check);
  if (claim.monotone) check_change(check);
}

std::optional<ClaimCheck> check_scene(const Claim& claim, const std::string& scene,
                                      std::span<const ResultRow> rows) {
  ClaimCheck check{scene, {}};
  for (const auto& group : claim.order)
    for (const std::string& call : group) {
      auto value = value_of(claim.by, scene, call, rows);
      if (!value) return std::nullopt;
      value->of = call;
      check.values.push_back(std::move(*value));
    }
  hold_against(claim, check);
  return check;
}

/// The mean of the i-th value of all checks, without an interval where one of them has none. The
/// PSNR of equal pictures is infinite, and counts where all are.
ClaimedValue mean_value(std::span<const ClaimCheck> checks, std::size_t i) {
  std::vector<const ClaimedValue*> values;
  for (const ClaimCheck& check : checks) values.push_back(&check.values[i]);
  const auto is_infinite = [](const ClaimedValue* value) { return std::isinf(value->value); };
  if (!std::ranges::all_of(values, is_infinite)) std::erase_if(values, is_infinite);
  ClaimedValue mean{checks[0].values[i].of, 0, Interval{}};
  for (const ClaimedValue* value : values) {
    mean.value += value->value / double(values.size());
    if (!value->interval) mean.interval.reset();
    if (!mean.interval) continue;
    mean.interval->low += value->interval->low / double(values.size());
    mean.interval->high += value->interval->high / double(values.size());
  }
  return mean;
}

ClaimCheck mean_of(const Claim& claim, std::span<const ClaimCheck> checks) {
  ClaimCheck mean{"mean", {}};
  for (std::size_t i = 0; i < checks[0].values.size(); ++i)
    mean.values.push_back(mean_value(checks, i));
  hold_against(claim, mean);
  return mean;
}

/// One scene is enough: what others say counts where none agrees.
void keep_best(std::vector<ClaimCheck>& checks) {
  const auto agrees = [](const ClaimCheck& c) { return c.against.empty() && c.undecided.empty(); };
  const auto is_open = [](const ClaimCheck& c) { return c.against.empty(); };
  if (std::ranges::any_of(checks, agrees))
    std::erase_if(checks, std::not_fn(agrees));
  else if (std::ranges::any_of(checks, is_open))
    std::erase_if(checks, std::not_fn(is_open));
}

std::vector<ClaimCheck> check_scene_order(const Claim& claim, std::span<const ResultRow> rows) {
  std::vector<ClaimCheck> checks;
  for (const std::string& call : claim.order.front()) {
    ClaimCheck check{call, {}};
    for (const std::string& scene : claim.scenes)
      if (auto value = value_of(claim.by, scene, call, rows)) {
        value->of = scene;
        check.values.push_back(std::move(*value));
      }
    if (check.values.size() != claim.scenes.size()) continue;
    check_order(claim, std::vector<std::size_t>(claim.scenes.size(), 1), check);
    checks.push_back(std::move(check));
  }
  return checks;
}

}  // namespace

std::optional<double> ClaimedNumber::of(const ResultRow& row) const {
  if (!stage.empty()) return share_of_stage(row, stage);
  return column ? column->value(row) : measure_of(row, measure);
}

std::optional<Interval> ClaimedNumber::interval_of(const ResultRow& row) const {
  if (column) return place_of(*column, row);
  if (stage.empty()) return interval_of_measure(row, measure);
  const std::optional<double> exact = of(row);
  return exact ? std::optional(Interval{*exact, *exact}) : std::nullopt;
}

std::string ClaimedNumber::text(double value) const {
  return column ? number_for_people(column->style, value) : fmt::format("{:.3g}", value);
}

std::string ClaimedNumber::heading() const {
  if (!stage.empty()) return fmt::format("share of '{}'", stage);
  return column ? compare::heading(*column) : measure;
}

std::string verdict(const ClaimCheck& check) {
  if (!check.against.empty())
    return fmt::format("otherwise here: {}", fmt::join(check.against, "; "));
  if (!check.undecided.empty())
    return fmt::format("undecided: {}", fmt::join(check.undecided, "; "));
  return "the same here";
}

std::vector<ClaimCheck> check_claim(const Claim& claim, std::span<const std::string> scenes,
                                    std::span<const ResultRow> rows) {
  if (claim.orders_scenes) return check_scene_order(claim, rows);
  if (!claim.scenes.empty()) scenes = claim.scenes;
  std::vector<ClaimCheck> checks;
  for (const std::string& scene : scenes)
    if (auto check = check_scene(claim, scene, rows)) checks.push_back(std::move(*check));
  if (claim.somewhere)
    keep_best(checks);
  else if (checks.size() > 1)
    checks.push_back(mean_of(claim, checks));
  return checks;
}

}  // namespace pellucid::compare
