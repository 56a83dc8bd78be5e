// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/pack/archive.h"

#include <gmock/gmock.h>

#include <cstdlib>

#include "core/error.h"
#include "core/files/output_file.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;

/// A text, an empty one, a file of bytes, a program, and a name longer than tar's own field.
class UnitArchive : public ::testing::Test {
 protected:
  UnitArchive() {
    write_text(folder_ / "bytes", bytes_);
    files_ = {{.path = "a.txt", .text = "one\n"},
              {.path = "deep/empty", .text = ""},
              {.path = "deep/bytes", .source = folder_ / "bytes"},
              {.path = "run.sh", .text = "#!/bin/sh\n", .executable = true},
              {.path = std::string(120, 'd') + "/" + std::string(90, 'f'), .text = "long"},
              {.path = "ro-crate-metadata.json", .text = "{}"}};
  }

  void expect_all_in(const fs::path& folder) const {
    for (const PackedFile& file : files_) {
      ASSERT_TRUE(fs::exists(folder / file.path)) << file.path;
      EXPECT_EQ(read_text(folder / file.path), file.content()) << file.path;
    }
    EXPECT_NE(fs::status(folder / "run.sh").permissions() & fs::perms::owner_exec, fs::perms::none);
    EXPECT_EQ(fs::status(folder / "a.txt").permissions() & fs::perms::owner_exec, fs::perms::none);
  }
  /// By a program of others, where it is installed.
  void expect_unpacked(const std::string& command) const {
    ASSERT_EQ(std::system(("cd " + folder_.path().string() + " && " + command).c_str()), 0);
    expect_all_in(folder_ / "name");
  }

  testing::TemporaryFolder folder_;
  std::string bytes_ = std::string(100'000, '\0') + "\xff\x80" + std::string(513, 'x');
  std::vector<PackedFile> files_;
};

TEST_F(UnitArchive, TarUnpacksIt) {
  write_package(folder_ / "p.tar.gz", "name", files_);
  expect_unpacked("tar xzf p.tar.gz");
}

TEST_F(UnitArchive, PythonUnpacksAZip) {
  write_package(folder_ / "p.zip", "name", files_);
  ASSERT_EQ(std::system(("cd " + folder_.path().string() +
                         " && /usr/bin/python3 -c \"import zipfile, os; z = "
                         "zipfile.ZipFile('p.zip'); assert z.testzip() is None; "
                         "[os.chmod(z.extract(i), i.external_attr >> 16) for i in z.infolist()]\"")
                            .c_str()),
            0);
  expect_all_in(folder_ / "name");
}

/// In whatever locale the program runs: bit 11 of a .zip's flags says that names are UTF-8, a .tar
/// says so by saying nothing else (POSIX, pax), and names that are none are kept as they are.
TEST_F(UnitArchive, NamesAreUtf8) {
  files_.push_back({.path = "d\u00e9j\u00e0 \u2013 1.txt", .text = "vu"});
  write_package(folder_ / "p.zip", "name", files_);
  write_package(folder_ / "p.tar.gz", "name", files_);
  const auto python = [&](const std::string& text) {
    write_text(folder_ / "t.py", text);
    return std::system(("cd " + folder_.path().string() + " && /usr/bin/python3 t.py").c_str());
  };
  EXPECT_EQ(
      python("import zipfile\n"
             "i = [i for i in zipfile.ZipFile('p.zip').infolist()"
             " if i.filename.endswith('1.txt')][0]\n"
             "assert i.filename == 'name/d\\u00e9j\\u00e0 \\u2013 1.txt', ascii(i.filename)\n"),
      0);
  EXPECT_EQ(python("import tarfile\n"
                   "assert all('hdrcharset' not in i.pax_headers for i in"
                   " tarfile.open('p.tar.gz').getmembers())\n"),
            0);
  files_.back().path = "\xff.txt";
  write_package(folder_ / "p.tar.gz", "name", files_);
  expect_unpacked("rm -rf name && tar xzf p.tar.gz");
}

/// As all other endings.
TEST_F(UnitArchive, CapitalLettersAreTheSameEnding) {
  write_package(folder_ / "P.ZIP", "name", files_);
  EXPECT_TRUE(fs::is_regular_file(folder_ / "P.ZIP"));
  EXPECT_EQ(package_name("x/P.Tar.GZ"), "P");
}

TEST_F(UnitArchive, AFolderIsReplacedOnlyByItsLike) {
  write_package(folder_ / "p", "name", files_);
  expect_all_in(folder_ / "p");
  write_package(folder_ / "p", "name", files_);
  write_text(folder_ / "p" / "notes.txt", "of who unpacked it");
  EXPECT_THROW(write_package(folder_ / "p", "name", files_), InputError);
}

TEST_F(UnitArchive, TheSameFilesAreTheSameBytes) {
  for (const char* name : {"a.zip", "b.zip", "a.tgz", "b.tgz"})
    write_package(folder_ / name, "name", files_);
  EXPECT_EQ(read_text(folder_ / "a.zip"), read_text(folder_ / "b.zip"));
  EXPECT_EQ(read_text(folder_ / "a.tgz"), read_text(folder_ / "b.tgz"));
}

TEST(UnitPackageName, IsThePathsWithoutItsEnding) {
  EXPECT_EQ(package_name("x/blending.tar.gz"), "blending");
  EXPECT_EQ(package_name("blending.v2.zip"), "blending.v2");
  EXPECT_EQ(package_name("x/folder/"), "folder");
  EXPECT_EQ(package_name(".zip"), ".zip");
}

}  // namespace
}  // namespace pellucid::compare
