// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/run/contest.h"

#include <algorithm>
#include <optional>

namespace pellucid::compare {
namespace {

class Contest {
 public:
  Contest(std::size_t contenders, const TimingRule& rule, const TimeOnce& time_once)
      : rule_(rule), time_once_(time_once), in_(contenders, true), seconds_(contenders) {}

  /// Times each once that is in, from the `first`-th around.
  void run_round(std::size_t first) {
    for (std::size_t i = 0; i < in_.size(); ++i) {
      const std::size_t contender = (first + i) % in_.size();
      if (in_[contender]) seconds_[contender] = time_once_(contender);
    }
  }

  /// Puts those out whose interval does not overlap that of the least median, once there are both.
  void put_slower_out() {
    std::vector<Spread> spreads(in_.size());
    std::optional<std::size_t> least;
    for (std::size_t i = 0; i < in_.size(); ++i) {
      if (!in_[i]) continue;
      spreads[i] = spread_of(seconds_[i], rule_);
      if (!least || spreads[i].median < spreads[*least].median) least = i;
    }
    if (!spreads[*least].interval) return;
    for (std::size_t i = 0; i < in_.size(); ++i)
      if (in_[i] && spreads[i].interval)
        in_[i] = overlap(*spreads[i].interval, *spreads[*least].interval);
  }

  bool is_decided() const {
    bool all_over = true;
    for (std::size_t i = 0; i < in_.size(); ++i)
      if (in_[i]) all_over &= is_over(seconds_[i], rule_);
    return all_over || std::ranges::count(in_, true) == 1;
  }

  const std::vector<bool>& in() const { return in_; }

 private:
  const TimingRule& rule_;
  const TimeOnce& time_once_;
  std::vector<bool> in_;
  std::vector<std::span<const double>> seconds_;
};

}  // namespace

std::vector<bool> fastest_of(std::size_t contenders, const TimingRule& rule,
                             const TimeOnce& time_once, const std::function<bool()>& may_go_on) {
  Contest contest(contenders, rule, time_once);
  for (std::size_t round = 0; contenders > 0 && may_go_on(); ++round) {
    contest.run_round(round);
    contest.put_slower_out();
    if (contest.is_decided()) break;
  }
  return contest.in();
}

}  // namespace pellucid::compare
