// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/output_file.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "core/error.h"
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
