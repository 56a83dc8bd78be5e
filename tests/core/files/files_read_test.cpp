// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/files_read.h"

#include <gtest/gtest.h>

#include <fstream>

#include "core/error.h"
#include "core/files/output_file.h"
#include "core/parallel.h"
#include "tests/support/temporary_folder.h"

namespace pellucid {
namespace {

using testing::TemporaryFolder;

TEST(UnitFilesRead, ListsWhatAnyThreadReadsWhileItLives) {
  const TemporaryFolder folder;
  for (int i = 0; i < 10; ++i) write_text(folder / std::to_string(i), "x");
  read_text(folder / "0");
  const FilesRead outer;
  read_text(folder / "1");
  {
    const FilesRead inner;
    parallel_for(2, 6, [&](int i) { read_text(folder / std::to_string(i)); });
    read_text(folder / "./2");
    EXPECT_EQ(inner.paths().size(), 4u);
  }
  read_text(folder / "6");
  EXPECT_EQ(outer.paths().size(), 6u);
  EXPECT_TRUE(outer.paths().contains(folder / "6"));
  EXPECT_FALSE(outer.paths().contains(folder / "0"));
}

/// Behind a link ".." is not the folder in which the link lies.
TEST(UnitFilesRead, FollowsLinksBeforeItGoesUp) {
  namespace fs = std::filesystem;
  const TemporaryFolder folder;
  fs::create_directories(folder / "data/scenes");
  write_text(folder / "data/mesh", "first");
  fs::create_directory_symlink(folder / "data/scenes", folder / "scenes");
  const fs::path there = folder / "scenes/../mesh";
  const fs::path mesh = fs::canonical(folder.path()) / "data" / "mesh";
  EXPECT_EQ(without_dots(there), mesh);
  EXPECT_EQ(without_dots(folder / "data/scenes/.././mesh"), folder / "data/mesh");
  EXPECT_EQ(without_dots("a/../b"), "b");  // nothing is there
  const ProtectedInputs inputs;
  const FilesRead files;
  read_text(there);
  EXPECT_TRUE(files.paths().contains(mesh));
  EXPECT_THROW(ProtectedInputs::refuse(folder / "data/mesh"), InputError);
  const std::string before = ContentHashes().of(*files.paths().begin());
  EXPECT_EQ(before.size(), 16u);
  std::ofstream(mesh) << "second";
  EXPECT_NE(ContentHashes().of(*files.paths().begin()), before);
}

TEST(UnitContentHashes, AreOfTheContentAlone) {
  const TemporaryFolder folder;
  const std::string large(3 << 20, 'a');
  write_text(folder / "a", large);
  write_text(folder / "b", large);
  write_text(folder / "c", large.substr(1) + "b");
  write_text(folder / "empty", "");
  ContentHashes hashes;
  EXPECT_EQ(hashes.of(folder / "a"), hashes.of(folder / "b"));
  EXPECT_NE(hashes.of(folder / "a"), hashes.of(folder / "c"));
  EXPECT_EQ(hashes.of(folder / "empty"), "2d06800538d394c2");  // XXH3 of nothing, as published
  EXPECT_EQ(hashes.of(folder / "none"), "");
  EXPECT_EQ(hashes.of(folder.path()), "");
}

}  // namespace
}  // namespace pellucid
