// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/run/contest.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "compare/timing/median_interval.h"

namespace pellucid::compare {
namespace {

constexpr double far = 1.5;  // times the median of another one
/// One time of so many medians may be that of one who is as fast: noise of a tenth.
constexpr double near_enough = 1.2;
constexpr double confidence_if_near = 0.999;
constexpr int times_if_near = 11;  // the fewest whose range holds the median with 1 - 2^-10
constexpr int fewest_times = 5;
/// So often in a row whoever is far is timed again before it is out for good.
constexpr int times_to_confirm = 3;

class Contest {
 public:
  Contest(std::size_t contenders, const TimingRule& rule, const TimeOnce& time_once)
      : rule_(rule),
        time_once_(time_once),
        in_(contenders, true),
        is_doubted_(contenders, false),
        earlier_(contenders),
        seconds_(contenders) {}

  /// Times each once that is in, from the `first`-th around. Returns whether all had their turn.
  bool run_round(std::size_t first, const std::function<bool()>& may_go_on) {
    for (std::size_t i = 0; i < in_.size(); ++i) {
      const std::size_t contender = (first + i) % in_.size();
      if (!in_[contender]) continue;
      if (!may_go_on()) return false;
      time(contender);
    }
    return true;
  }

  /// Puts those out whose interval does not overlap that of the least median, once there are both.
  void put_slower_out() {
    std::optional<std::size_t> least;
    for (std::size_t i = 0; i < in_.size(); ++i)
      if (in_[i] && (!least || median(i) < median(*least))) least = i;
    for (std::size_t i = 0; i < in_.size(); ++i)
      if (in_[i] && i != *least && is_slower(i, *least)) put_out(i);
  }

  /// Times those that are out from afar again, all in a row: what has disturbed one of them in its
  /// turns, and not the others, hardly does so then, too. Takes in who is no slower than the least
  /// median; of them only times that are apart beyond most doubt tell. Returns whether all are out.
  bool confirm(const std::function<bool()>& may_go_on) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < in_.size(); ++i)
      if (in_[i]) least = std::min(least, median(i));
    bool all_are_out = true;
    for (const std::size_t i : std::exchange(far_, {}))
      for (int k = 0; k < times_to_confirm && !in_[i] && may_go_on(); ++k) {
        time(i);
        if (seconds_[i].back() > near_enough * least) continue;
        in_[i] = is_doubted_[i] = true;
        all_are_out = false;
      }
    return all_are_out;
  }

  double median(std::size_t contender) const {
    return median_of({seconds_[contender].begin(), seconds_[contender].end()});
  }

  /// There is a look after every round, at every pair: the more often one looks, the likelier
  /// chance parts two that are equal. Who is near has to be slower beyond most doubt.
  bool is_slower(std::size_t contender, std::size_t than) const {
    const bool is_near = is_doubted_[contender] || median(contender) < far * median(than);
    const double confidence = is_near ? confidence_if_near : usual_confidence;
    const auto needed = std::size_t(is_near ? times_if_near : fewest_times);
    if (std::min(seconds_[contender].size(), seconds_[than].size()) < needed) return false;
    const auto interval = [&](std::size_t i) {
      return *median_interval({seconds_[i].begin(), seconds_[i].end()}, confidence);
    };
    return !overlap(interval(contender), interval(than));
  }

  bool is_decided() const {
    const auto enough = std::size_t(std::min(times_if_near, rule_.max));
    bool all_over = true;
    for (std::size_t i = 0; i < in_.size(); ++i)
      if (in_[i]) all_over &= seconds_[i].size() >= enough && is_over(seconds_[i], rule_);
    return all_over || std::ranges::count(in_, true) == 1;
  }

  const std::vector<bool>& in() const { return in_; }

 private:
  /// Those that were taken before, one contender's at another time than the others', tell nothing
  /// of who is faster.
  void time(std::size_t contender) {
    const std::span<const double> all = time_once_(contender);
    if (!earlier_[contender]) earlier_[contender] = all.size() - 1;
    seconds_[contender] = all.subspan(*earlier_[contender]);
  }

  void put_out(std::size_t contender) {
    in_[contender] = false;
    if (seconds_[contender].size() < std::size_t(times_if_near)) far_.push_back(contender);
  }

  const TimingRule& rule_;
  const TimeOnce& time_once_;
  std::vector<bool> in_, is_doubted_;
  std::vector<std::size_t> far_;  // who is out by a few times, until that is confirmed
  std::vector<std::optional<std::size_t>> earlier_;  // times from before
  std::vector<std::span<const double>> seconds_;
};

}  // namespace

std::vector<bool> fastest_of(std::size_t contenders, const TimingRule& rule,
                             const TimeOnce& time_once, const std::function<bool()>& may_go_on) {
  Contest contest(contenders, rule, time_once);
  for (std::size_t round = 0; contenders > 0 && contest.run_round(round, may_go_on); ++round) {
    contest.put_slower_out();
    if (contest.is_decided() && contest.confirm(may_go_on)) break;
  }
  return contest.in();
}

}  // namespace pellucid::compare
