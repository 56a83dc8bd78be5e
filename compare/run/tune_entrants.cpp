// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/run/tune_entrants.h"

#include <algorithm>
#include <limits>
#include <tuple>

#include "compare/run/contest.h"

namespace pellucid::compare {
namespace {

constexpr double contender_within = 2;  // the least of a few times is known to such a factor
constexpr int fair_times = 5;
constexpr std::size_t most_contenders = 12;  // they have their memory at once
constexpr double narrow = 0.01;
constexpr int fewest_times = 5;

/// An error that is not known is no small one.
double rmse_of(const ResultRow& row) {
  return row.metrics.linear.of("rmse").value_or(std::numeric_limits<double>::infinity());
}

/// Whose row comes first in the table: by the cost that was asked for, of equal bytes by the error.
bool is_cheaper(Cost cost, const ResultRow& a, const ResultRow& b) {
  if (a.error.empty() != b.error.empty()) return a.error.empty();
  if (cost == Cost::seconds) return a.seconds.median < b.seconds.median;
  const auto bytes_and_error = [](const ResultRow& row) {
    return std::pair(known_bytes(row), rmse_of(row));
  };
  return bytes_and_error(a) < bytes_and_error(b);
}

}  // namespace

bool is_slower(CellMeter& one, CellMeter& than, double factor, const IsOver& is_over) {
  double of_one = std::numeric_limits<double>::infinity(), of_other = of_one;
  for (int k = 0; k < fair_times && !is_over(); ++k)
    for (auto& [meter, least] : {std::pair(&one, &of_one), std::pair(&than, &of_other)}) {
      meter->time_once();
      *least = std::min(*least, meter->seconds().back());
    }
  return of_one > factor * of_other;
}

void keep_contenders(std::span<Entrant> entrants, const IsOver& is_over) {
  std::vector<Entrant*> in;
  for (Entrant& entrant : entrants)
    if (entrant.meter) in.push_back(&entrant);
  std::ranges::stable_sort(in, {}, [](const Entrant* e) { return e->least_seconds(); });
  for (std::size_t i = 1; i < in.size(); ++i) {
    const double times = in[i]->least_seconds() / in.front()->least_seconds();
    const bool is_out = i >= most_contenders || times > hopeless ||
                        (times > contender_within &&
                         is_slower(*in[i]->meter, *in.front()->meter, contender_within, is_over));
    if (is_out) finish(*in[i], fixed_repeats(2));
  }
}

void finish(Entrant& entrant, const TimingRule& rule) {
  CellMeasurement measured = entrant.meter->finish(rule);
  measured.row.metrics = entrant.row.metrics;
  measured.row.given_faults = std::move(entrant.row.given_faults);
  entrant.row = std::move(measured.row);
  entrant.meter.reset();
}

void weigh(std::span<Entrant> entrants) {
  std::uint64_t fewest = std::numeric_limits<std::uint64_t>::max();
  for (const Entrant& entrant : entrants)
    if (entrant.within) fewest = std::min(fewest, known_bytes(entrant.row));
  for (Entrant& entrant : entrants)
    entrant.tied = entrant.within && known_bytes(entrant.row) == fewest;
}

void time_contenders(std::span<Entrant> entrants, int repeats, const IsOver& is_over,
                     const std::function<void(const Entrant&)>& tell) {
  std::vector<Entrant*> contenders;
  for (Entrant& entrant : entrants)
    if (entrant.meter) contenders.push_back(&entrant);
  const TimingRule rule{std::min(fewest_times, repeats), repeats, narrow};
  const auto time_once = [&](std::size_t i) {
    tell(*contenders[i]);
    contenders[i]->meter->time_once();
    return contenders[i]->meter->seconds();
  };
  const std::vector<bool> in =
      fastest_of(contenders.size(), rule, time_once, [&] { return !is_over(); });
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < contenders.size(); ++i) {
    best = std::min(best, contenders[i]->least_seconds());
    contenders[i]->tied = in[i];
    finish(*contenders[i], rule);
  }
  // Of one time alone, which tells no more than that.
  for (Entrant& entrant : entrants)
    if (entrant.of_reference && entrant.within)
      entrant.tied = entrant.row.seconds.median <= contender_within * best;
}

void rank(std::vector<Entrant> entrants, Cost cost, TuneOutcome& outcome) {
  std::erase_if(entrants, [](const Entrant& entrant) { return !entrant.drawn; });
  std::ranges::stable_sort(entrants, {}, &Entrant::place);
  std::ranges::stable_sort(
      entrants, [&](const Entrant& a, const Entrant& b) { return is_cheaper(cost, a.row, b.row); });
  const auto steady = [](const Entrant& e) {
    return std::tuple(known_bytes(e.row), rmse_of(e.row), e.place);
  };
  const Entrant* cheapest = nullptr;
  for (const Entrant& entrant : entrants)
    if (entrant.tied && (!cheapest || steady(entrant) < steady(*cheapest))) cheapest = &entrant;
  for (Entrant& entrant : entrants) {
    if (&entrant == cheapest) outcome.cheapest = outcome.rows.size();
    outcome.within_bound.push_back(entrant.within);
    outcome.tied.push_back(entrant.tied && &entrant != cheapest);
    outcome.rows.push_back(std::move(entrant.row));
  }
}

}  // namespace pellucid::compare
