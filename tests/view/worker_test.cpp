// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/frames/worker.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>

#include "core/error.h"
#include "core/parallel.h"

namespace pellucid::view {
namespace {

using namespace std::chrono_literals;

/// Runs `work` for a page on a thread; whether it was replaced.
std::future<bool> replaced(Worker& worker, const std::string& page, const Worker::Work& work) {
  return std::async(std::launch::async, [&worker, page, work] {
    try {
      worker.run(page, work);
      return false;
    } catch (const Replaced&) {
      return true;
    }
  });
}

/// Work that runs until it is cancelled, and says when it has begun.
struct Endless {
  std::promise<void> begun;

  Worker::Work work() {
    return [this](const Progress& progress) {
      begun.set_value();
      for (;;) {
        report(progress, 0, "");
        std::this_thread::sleep_for(1ms);
      }
    };
  }
  void wait() { begun.get_future().wait(); }
};

TEST(UnitWorker, ReturnsWhatTheWorkThrows) {
  Worker worker;
  EXPECT_THROW(worker.run("a", [](const Progress&) { throw InputError("wrong"); }), InputError);
  bool done = false;
  worker.run("a", [&](const Progress&) { done = true; });
  EXPECT_TRUE(done);
}

TEST(UnitWorker, NewerWorkOfAPageEndsTheOlder) {
  Worker worker;
  Endless older;
  auto is_replaced = replaced(worker, "a", older.work());
  older.wait();
  worker.run("a", [](const Progress&) {});
  EXPECT_TRUE(is_replaced.get());
}

// Loops end early, too, though nothing asks for their progress.
TEST(UnitWorker, EndsLoopsThatRun) {
  Worker worker;
  std::promise<void> begun;
  std::atomic<int> count = 0;
  constexpr int all = 1 << 28;  // would take a day, but for whom nobody ends
  const auto give_up = std::chrono::steady_clock::now() + 20s;
  auto is_replaced = replaced(worker, "a", [&](const Progress&) {
    parallel_for(0, all, [&](int) {
      if (count++ == 0) begun.set_value();
      if (std::chrono::steady_clock::now() < give_up) std::this_thread::sleep_for(1ms);
    });
  });
  begun.get_future().wait();
  worker.run("a", [](const Progress&) {});
  EXPECT_TRUE(is_replaced.get());
  EXPECT_LT(count, all);
}

TEST(UnitWorker, AnotherPagesWorkWaits) {
  Worker worker;
  std::promise<void> begun, may_end;
  auto is_replaced = replaced(worker, "a", [&](const Progress&) {
    begun.set_value();
    may_end.get_future().wait();
  });
  begun.get_future().wait();
  auto other = replaced(worker, "b", [](const Progress&) {});
  EXPECT_EQ(other.wait_for(20ms), std::future_status::timeout);
  may_end.set_value();
  EXPECT_FALSE(is_replaced.get());
  EXPECT_FALSE(other.get());
}

TEST(UnitWorker, ItsEndEndsAllThatRunsAndWaits) {
  Worker worker;
  Endless running;
  auto first = replaced(worker, "a", running.work());
  running.wait();
  auto second = replaced(worker, "b", [](const Progress&) {});
  worker.end();
  EXPECT_TRUE(first.get());
  EXPECT_TRUE(second.get());
  EXPECT_THROW(worker.run("c", [](const Progress&) {}), Replaced);
}

}  // namespace
}  // namespace pellucid::view
