// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/output_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <thread>
#include <vector>

#include "core/error.h"
#include "core/files/files_read.h"
#include "tests/support/temporary_folder.h"

namespace pellucid {
namespace {

namespace fs = std::filesystem;

class UnitOutputFile : public ::testing::Test {
 protected:
  bool folder_is_empty() const { return fs::is_empty(folder_.path()); }

  testing::TemporaryFolder folder_;
};

TEST_F(UnitOutputFile, AppearsWhole) {
  write_text(folder_ / "a.txt", "one\n");
  write_text(folder_ / "a.txt", "two\n");
  EXPECT_EQ(read_text(folder_ / "a.txt"), "two\n");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()), 1);
}

TEST_F(UnitOutputFile, LeavesNothingWithoutCommit) {
  {
    const OutputFile out(folder_ / "a.png");
    EXPECT_EQ(out.temporary().extension(), ".png");
    std::ofstream(out.temporary()) << "half";
    EXPECT_FALSE(folder_is_empty());
  }
  EXPECT_TRUE(folder_is_empty());
}

TEST_F(UnitOutputFile, RefusesAMissingFolderAndAFolderInItsPlace) {
  EXPECT_THROW(write_text(folder_ / "none" / "a.txt", "x"), InputError);
  EXPECT_THROW(write_text(folder_.path(), "x"), InputError);
  EXPECT_THROW(read_text(folder_ / "none"), InputError);
}

TEST_F(UnitOutputFile, ALinkStaysALinkToWhatIsWritten) {
  write_text(folder_ / "target.txt", "old");
  fs::create_symlink("target.txt", folder_ / "link.txt");
  write_text(folder_ / "link.txt", "new");
  EXPECT_TRUE(fs::is_symlink(folder_ / "link.txt"));
  EXPECT_EQ(read_text(folder_ / "target.txt"), "new");
  fs::create_symlink("none.txt", folder_ / "dangling.txt");
  write_text(folder_ / "dangling.txt", "made");
  EXPECT_EQ(read_text(folder_ / "none.txt"), "made");
}

TEST_F(UnitOutputFile, ALoopOfLinksIsRefusedAndStays) {
  std::filesystem::create_symlink("b", folder_ / "a");
  std::filesystem::create_symlink("a", folder_ / "b");
  EXPECT_THROW(write_text(folder_ / "a", "x"), InputError);
  EXPECT_TRUE(std::filesystem::is_symlink(folder_ / "a"));
  EXPECT_TRUE(std::filesystem::is_symlink(folder_ / "b"));
}

TEST_F(UnitOutputFile, ADeviceIsWrittenIntoAndStays) {
  write_text("/dev/null", "nothing");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_THROW(write_text("/dev/full", "x"), WorkError);
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST_F(UnitOutputFile, APipeIsWrittenIntoAndStays) {
  const fs::path pipe = folder_ / "pipe.txt";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::string got;
  std::thread reader([&] { std::getline(std::ifstream(pipe) >> std::ws, got, '\0'); });
  write_text(pipe, "through");
  reader.join();
  EXPECT_EQ(got, "through");
  EXPECT_TRUE(fs::is_fifo(pipe));
}

TEST_F(UnitOutputFile, WhatAKilledProcessLeftIsRemoved) {
  std::ofstream(folder_ / ".a.4294967.txt") << "half";
  std::ofstream(folder_ / ".a.b.txt") << "mine";  // no number of a process
  std::ofstream(folder_ / ".b.4294967.txt") << "another's";
  const int held = ::open((folder_ / ".a.4294968.txt").c_str(), O_WRONLY | O_CREAT, 0600);
  ASSERT_EQ(::flock(held, LOCK_EX), 0);  // its writer lives
  write_text(folder_ / "a.txt", "x");
  EXPECT_FALSE(fs::exists(folder_ / ".a.4294967.txt"));
  EXPECT_TRUE(fs::exists(folder_ / ".a.4294968.txt"));
  EXPECT_TRUE(fs::exists(folder_ / ".a.b.txt"));
  EXPECT_TRUE(fs::exists(folder_ / ".b.4294967.txt"));
  ::close(held);
}

/// Each writes a file of its own, and does not take another's for one that a killed process left.
TEST_F(UnitOutputFile, ThreadsMayWriteOneFileAtOnce) {
  std::vector<std::thread> writers;
  std::atomic<int> failures = 0;
  for (int k = 0; k < 4; ++k)
    writers.emplace_back([&, k] {
      for (int i = 0; i < 100; ++i) try {
          write_text(folder_ / "one.txt", std::string(1000 + std::size_t(k), char('a' + k)));
        } catch (const std::exception&) {
          ++failures;
        }
    });
  for (std::thread& writer : writers) writer.join();
  EXPECT_EQ(failures, 0);
  const std::string text = read_text(folder_ / "one.txt");
  EXPECT_EQ(text, std::string(1000 + std::size_t(text[0] - 'a'), text[0]));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), {}), 1);
}

TEST_F(UnitOutputFile, AnInputIsNotWrittenOver) {
  write_text(folder_ / "in.txt", "x");
  fs::create_symlink("in.txt", folder_ / "link.txt");
  fs::create_hard_link(folder_ / "in.txt", folder_ / "hard.txt");
  {
    const ProtectedInputs inputs;
    read_text(folder_ / "in.txt");
    for (const char* name : {"in.txt", "link.txt", "hard.txt", "./in.txt"})
      EXPECT_THROW(write_text(folder_ / name, "y"), InputError) << name;
    write_text(folder_ / "out.txt", "y");
  }
  EXPECT_EQ(read_text(folder_ / "in.txt"), "x");
  write_text(folder_ / "in.txt", "y");  // nobody protects it any more
}

TEST_F(UnitOutputFile, OnlyFilesAreRead) {
  const fs::path pipe = folder_ / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THROW(read_text(pipe), InputError);  // and does not wait for a writer
  EXPECT_THROW(read_text("/dev/zero"), InputError);
  std::ofstream(folder_ / "huge") << "";
  fs::resize_file(folder_ / "huge", std::uintmax_t(1) << 42);  // 4 TiB of holes
  EXPECT_THROW(read_text(folder_ / "huge"), InputError);
}

TEST(UnitFullDisk, IsAFailureOfTheWorkAndLeavesNothing) {
  // A file system of 64 KiB, where the machine lets us mount one.
  const testing::TemporaryFolder folder;
  const fs::path& mount = folder.path();
  if (std::system(("mount -t tmpfs -o size=64k tmpfs " + mount.string() + " 2>/dev/null").c_str()))
    GTEST_SKIP() << "may not mount a file system here";
  EXPECT_THROW(write_text(mount / "a.txt", std::string(1 << 20, 'x')), WorkError);
  EXPECT_TRUE(fs::is_empty(mount));
  EXPECT_EQ(std::system(("umount " + mount.string()).c_str()), 0);
}

}  // namespace
}  // namespace pellucid
