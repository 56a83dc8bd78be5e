// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "compare/timing/timing_rule.h"

namespace pellucid::compare {

/// Times a contender once more, by its index, and returns all of its times until now, in seconds.
using TimeOnce = std::function<std::span<const double>(std::size_t contender)>;

/// Returns which of so many contenders may be the fastest: one, or several that are tied. They are
/// timed in turn, each round beginning with another one. One whose interval does not overlap that
/// of the least median any more is out, by intervals of 99.9 % where their medians are within half
/// of each other, which take eleven times, and else after three more times in a row. Only times of
/// the contest count, each round's being taken at one time; the rule's `min` and `max` bound the
/// times of each, and where the intervals of all that are left are as narrow as the rule asks,
/// nothing more is found out. Below five times there is no interval, and all are tied. Ends early
/// where `may_go_on` says so.
std::vector<bool> fastest_of(std::size_t contenders, const TimingRule& rule,
                             const TimeOnce& time_once, const std::function<bool()>& may_go_on);

}  // namespace pellucid::compare
