// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cfenv>
#include <limits>
#include <thread>

#include "core/float_environment.h"

namespace pellucid {
namespace {

#if defined(__SSE__)

constexpr unsigned flush_and_zero = 0x8040;  // FTZ and DAZ of MXCSR

/// The step to the next number above zero is a denormal number: with DAZ it counts as zero.
bool keeps_denormals() {
  volatile double smallest = std::numeric_limits<double>::denorm_min();
  return smallest * 1.0 > 0 && (_mm_getcsr() & flush_and_zero) == 0;
}

/// Calls check() on a thread whose arena began while denormal numbers were flushed, as when Embree
/// is the first to use TBB.
template <class Check>
void on_tainted_thread(const Check& check) {
  std::thread([&] {
    const unsigned before = _mm_getcsr();
    _mm_setcsr(before | flush_and_zero);
    tbb::parallel_for(0, 1000, [](int) {});
    _mm_setcsr(before);
    check();
  }).join();
}

TEST(UnitParallel, TbbAloneKeepsTheEnvironmentOfAnArenasBeginning) {
  std::atomic<int> flushed = 0;
  on_tainted_thread(
      [&] { tbb::parallel_for(0, 1000, [&](int) { flushed += !keeps_denormals(); }); });
  EXPECT_GT(flushed, 0) << "the tests below would prove nothing";
}

TEST(UnitParallel, EveryLoopHasItsCallersEnvironment) {
  on_tainted_thread([] {
    std::atomic<int> flushed = 0;
    parallel_for(0, 1000, [&](int) { flushed += !keeps_denormals(); });
    parallel_ranges(tbb::blocked_range<int>(0, 1000),
                    [&](const tbb::blocked_range<int>&) { flushed += !keeps_denormals(); });
    flushed += parallel_sum(
        tbb::blocked_range<int>(0, 1000), 0,
        [](const tbb::blocked_range<int>&, int sum) { return sum + !keeps_denormals(); },
        [](int a, int b) { return a + b; });
    parallel_for(0, 10, [&](int) {
      parallel_for(0, 100, [&](int) { flushed += !keeps_denormals(); });  // a loop in a task
    });
    EXPECT_EQ(flushed, 0);
  });
}

TEST(UnitParallel, DefaultFloatsHoldWhileTheyLive) {
  const unsigned before = _mm_getcsr();
  _mm_setcsr(before | flush_and_zero);
  {
    const DefaultFloats floats;
    EXPECT_TRUE(keeps_denormals());
  }
  EXPECT_EQ(_mm_getcsr() & flush_and_zero, flush_and_zero);
  _mm_setcsr(before);
}

#endif

TEST(UnitParallel, ALoopCarriesItsCallersRounding) {
  std::fesetround(FE_UPWARD);
  std::atomic<int> other = 0;
  parallel_for(0, 1000, [&](int) { other += std::fegetround() != FE_UPWARD; });
  std::fesetround(FE_TONEAREST);
  EXPECT_EQ(other, 0);
}

TEST(UnitParallel, ALoopThatIsCancelledDoesNotReturn) {
  tbb::task_group_context work;
  tbb::task_group group(work);
  std::atomic<int> turns = 0;
  bool returned = false, left = false;
  group.run_and_wait([&] {
    try {
      parallel_for(0, 1000000, [&](int) {
        if (++turns == 100) work.cancel_group_execution();
      });
      returned = true;
    } catch (const Cancelled&) {
      left = true;
    }
  });
  EXPECT_TRUE(left && !returned);
  EXPECT_LT(turns, 1000000);
}

}  // namespace
}  // namespace pellucid
