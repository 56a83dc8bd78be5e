// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/run/contest.h"

#include <gmock/gmock.h>

#include <functional>
#include <iostream>
#include <random>

#include "tests/compare/timing/noises.h"

namespace pellucid::compare {
namespace {

using ::testing::ElementsAre;
using namespace testing;

/// Contenders whose times are drawn, and who was timed when.
class Contenders {
 public:
  explicit Contenders(std::vector<std::function<double()>> draw)
      : draw_(std::move(draw)), times_(draw_.size()) {}

  std::vector<bool> compete(const TimingRule& rule) {
    return fastest_of(
        draw_.size(), rule,
        [&](std::size_t i) {
          order.push_back(int(i));
          times_[i].push_back(draw_[i]());
          return std::span<const double>(times_[i]);
        },
        [&] { return order.size() < most; });
  }

  std::vector<int> order;
  std::size_t most = 100000;

 private:
  std::vector<std::function<double()>> draw_;
  std::vector<std::vector<double>> times_;
};

std::function<double()> always(double time) {
  return [time] { return time; };
}

TEST(UnitContest, TheFasterOneIsAloneOnceThereAreIntervals) {
  Contenders two({always(2), always(1)});
  EXPECT_THAT(two.compete({5, 30, 0.01}), ElementsAre(false, true));
  EXPECT_EQ(two.order.size(), 10u + 3);
  EXPECT_THAT(std::vector(two.order.begin(), two.order.begin() + 4), ElementsAre(0, 1, 1, 0));
}

TEST(UnitContest, EqualsAreTiedAndEndOnceTheyAreKnown) {
  Contenders three({always(1), always(1.5), always(1)});
  EXPECT_THAT(three.compete({5, 30, 0.01}), ElementsAre(true, false, true));
  EXPECT_EQ(three.order.size(), 11u + 5 + 11 + 3);
}

TEST(UnitContest, ANearOneIsOutAfterElevenTimes) {
  Contenders two({always(1), always(1.2)});
  EXPECT_THAT(two.compete({5, 30, 0.01}), ElementsAre(true, false));
  EXPECT_EQ(two.order.size(), 22u);
}

/// What was timed before, while something disturbed it, is no evidence.
TEST(UnitContest, TimesFromBeforeDoNotCount) {
  std::vector<std::vector<double>> times{{9, 9, 9, 9, 9}, {1, 1, 1, 1, 1}};
  const TimeOnce once = [&](std::size_t i) {
    times[i].push_back(i == 0 ? 1 : 1.2);
    return std::span<const double>(times[i]);
  };
  EXPECT_THAT(fastest_of(2, {5, 30, 0.01}, once, [] { return true; }), ElementsAre(true, false));
  EXPECT_EQ(times[0].size(), 5u + 11);
}

/// Six times are disturbed, then none: who was out comes in again, and is not told apart.
TEST(UnitContest, WhoIsFarIsTimedAgainBeforeItIsOut) {
  int drawn = 0;
  Contenders two({always(1.3), [&] { return ++drawn <= 6 ? 5. : 1.; }});
  EXPECT_THAT(two.compete({5, 30, 0.01}), ElementsAre(true, true));
}

TEST(UnitContest, EndsWhenTheTimeIsOverAlsoWithinARound) {
  for (const std::size_t most : {0u, 1u, 5u, 9u}) {
    Contenders two({always(2), always(1)});
    two.most = most;
    EXPECT_THAT(two.compete({5, 30, 0.01}), ElementsAre(true, true));
    EXPECT_EQ(two.order.size(), most);
  }
}

TEST(UnitContest, WithoutIntervalsAllAreTied) {
  Contenders two({always(2), always(1)});
  EXPECT_THAT(two.compete({4, 4, 0.01}), ElementsAre(true, true));
  EXPECT_EQ(two.order.size(), 8u);
}

TEST(UnitContest, OneAloneIsTimedOnceAndNoneNever) {
  Contenders one({always(2)});
  EXPECT_THAT(one.compete({5, 30, 0.01}), ElementsAre(true));
  EXPECT_EQ(one.order.size(), 1u);
  EXPECT_TRUE(Contenders({}).compete({5, 30, 0.01}).empty());
}

/// Of so many contests between times of 1 and of `ratio`, in noise: how many the slower one won
/// alone, and how many were tied.
struct Tally {
  double wrong = 0, tied = 0;
};

Tally tally(const Noise& noise, double ratio, std::mt19937_64& random) {
  constexpr int contests = 1000;
  Tally tally;
  for (int i = 0; i < contests; ++i) {
    Contenders two(
        {[&] { return noise.draw(random); }, [&] { return ratio * noise.draw(random); }});
    const std::vector<bool> in = two.compete({5, 30, 0.01});
    tally.wrong += double(!in[0]) / contests;
    tally.tied += double(in[0] && in[1]) / contests;
  }
  return tally;
}

// Two intervals of 96.5 % that do not overlap happen to equal times once in some hundred looks, and
// a contest looks up to 26 times: measured 1.4 % and less of 1000, which vary by 0.4 % (one
// deviation). The other one of the equal two wins as often.
TEST(PropertyContest, TheSlowerOneHardlyEverWins) {
  std::mt19937_64 random(3);
  for (const Noise& noise : skewed_noises())
    for (const double ratio : {1.0, 1.03}) {
      const Tally result = tally(noise, ratio, random);
      std::cout << noise.name << ", " << ratio << " times as long: " << 100 * result.wrong
                << " % wrong, " << 100 * result.tied << " % tied\n";
      EXPECT_LT(result.wrong, 0.04) << noise.name << ' ' << ratio;
    }
}

// Ten runs give one answer: of times that differ by a third, in noise of a tenth.
TEST(PropertyContest, ClearDifferencesAreToldInEveryRun) {
  std::mt19937_64 random(4);
  for (const Noise& noise : {skewed_noises()[0], skewed_noises()[1]}) {
    const Tally result = tally(noise, 1.33, random);
    EXPECT_EQ(result.wrong, 0) << noise.name;
    EXPECT_LT(result.tied, 0.01) << noise.name;
  }
}

/// A Machine is now and then disturbed for a while, whoever is being timed then.
class Machine {
 public:
  explicit Machine(std::uint64_t seed) : random_(seed) { change(); }

  /// What takes so many milliseconds undisturbed.
  double time(double needed) {
    constexpr double slower = 4;
    double taken = 0;
    while (needed > 0) {
      const double rate = is_disturbed_ ? slower : 1;
      const double part = std::min(needed * rate, left_);
      taken += part;
      needed -= part / rate;
      left_ -= part;
      if (left_ <= 0) change();
    }
    return taken;
  }

 private:
  void change() {
    is_disturbed_ = !is_disturbed_;
    left_ = std::exponential_distribution<double>(is_disturbed_ ? 1 / 40. : 1 / 60.)(random_);
  }

  std::mt19937_64 random_;
  bool is_disturbed_ = true;
  double left_ = 0;
};

// In bursts of 40 ms that come after 60 ms and make all four times as slow, of pictures of 3 ms:
// the fastest is never out, so that runs that differ say that it is tied. Each was timed by itself
// before, as tuning does.
TEST(PropertyContest, InBurstsTheFastestIsAloneOrTied) {
  constexpr double needed[] = {3.3, 3.4, 3.5, 5.4, 6};
  constexpr int contests = 1000;
  double out = 0, alone = 0, draws = 0;
  for (int seed = 0; seed < contests; ++seed) {
    Machine machine(std::uint64_t(seed) + 1);
    std::vector<std::vector<double>> times(std::size(needed));
    const TimeOnce once = [&](std::size_t i) {
      times[i].push_back(machine.time(needed[i]));
      ++draws;
      return std::span<const double>(times[i]);
    };
    for (std::size_t i = 0; i < times.size(); ++i)
      for (int k = 0; k < 4; ++k) once(i);
    const auto in = fastest_of(times.size(), {5, 30, 0.01}, once, [] { return true; });
    out += !in[0];
    alone += in[0] && std::ranges::count(in, true) == 1;
  }
  std::cout << "the fastest is out in " << out << " of " << contests << " contests, alone in "
            << alone << "; " << draws / contests << " pictures each\n";
  EXPECT_LE(out, 2);
}

}  // namespace
}  // namespace pellucid::compare
