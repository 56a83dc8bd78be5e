// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/file_lock.h"

#include <gtest/gtest.h>

#include <atomic>
#include <fstream>
#include <thread>
#include <vector>

#include "core/error.h"
#include "tests/support/temporary_folder.h"

namespace pellucid {
namespace {

namespace fs = std::filesystem;

// Of locks that are taken again and again some one waits for a file that has just been removed.
TEST(UnitFileLock, OneHasItAtATime) {
  const testing::TemporaryFolder folder;
  std::atomic<int> inside = 0, most = 0, turns = 0;
  std::vector<std::jthread> threads;
  for (int thread = 0; thread < 4; ++thread)
    threads.emplace_back([&] {
      for (int turn = 0; turn < 200; ++turn) {
        const FileLock lock(folder / "a.lock");
        most = std::max<int>(most, ++inside);
        std::this_thread::yield();
        --inside, ++turns;
      }
    });
  threads.clear();
  EXPECT_EQ(most, 1);
  EXPECT_EQ(turns, 800);
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(UnitFileLock, TheFileOfAKilledProcessIsNoLock) {
  const testing::TemporaryFolder folder;
  std::ofstream(folder / "a.lock").flush();
  { const FileLock lock(folder / "a.lock"); }
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(UnitFileLock, AFolderThatIsMissingIsNamed) {
  const testing::TemporaryFolder folder;
  EXPECT_THROW(FileLock(folder / "none" / "a.lock"), InputError);
}

}  // namespace
}  // namespace pellucid
