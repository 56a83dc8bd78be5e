// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/output_folder.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/files/files_read.h"
#include "core/files/output_file.h"
#include "tests/support/temporary_folder.h"

namespace pellucid {
namespace {

namespace fs = std::filesystem;

std::size_t entries(const fs::path& folder) {
  return std::size_t(std::distance(fs::directory_iterator(folder), {}));
}

TEST(UnitOutputFolder, AppearsWholeOrNotAtAll) {
  const testing::TemporaryFolder around;
  {
    const OutputFolder out(around / "made");
    write_text(out.temporary() / "mark", "1");
    EXPECT_FALSE(fs::exists(around / "made"));
  }
  EXPECT_EQ(entries(around.path()), 0u);
  OutputFolder out(around / "made/");
  write_text(out.temporary() / "mark", "2");
  out.commit();
  EXPECT_EQ(read_text(around / "made" / "mark"), "2");
  EXPECT_EQ(entries(around.path()), 1u);
}

TEST(UnitOutputFolder, ReplacesOnlyItsOwnKind) {
  const testing::TemporaryFolder around;
  for (const char* text : {"first", "second"}) {
    OutputFolder out(around / "made");
    write_text(out.temporary() / "mark", text);
    write_text(out.temporary() / text, "");
    out.commit();
  }
  EXPECT_EQ(read_text(around / "made" / "mark"), "second");
  EXPECT_FALSE(fs::exists(around / "made" / "first"));
  fs::create_directory(around / "mine");
  write_text(around / "mine" / "thesis.tex", "years");
  write_text(around / "mine" / "mark", "theirs, of the same name");
  EXPECT_THROW(OutputFolder(around / "mine"), InputError);
  EXPECT_THROW(OutputFolder(around / "mine" / "thesis.tex"), InputError);
  EXPECT_THROW(OutputFolder(around / "nowhere" / "deeper"), InputError);
  EXPECT_EQ(entries(around.path()), 2u);
}

TEST(UnitOutputFolder, WhatGoesWrongIsToldOfThePlaceThatWasAskedFor) {
  const testing::TemporaryFolder around;
  const OutputFolder out(around / "made/");
  const auto message = [&](const auto& write) -> std::string {
    try {
      out.fill(write);
    } catch (const std::exception& error) {
      return error.what();
    }
    return "";
  };
  const auto said = [](const fs::path& file) { return file.string() + ": cannot write: why"; };
  const std::string expected = said(around / "made" / "mark");
  EXPECT_EQ(message([&](const fs::path& to) { throw WorkError(said(to / "mark")); }), expected);
  EXPECT_EQ(message([&](const fs::path& to) { throw InputError(said(to / "mark")); }), expected);
  EXPECT_EQ(message([](const fs::path& to) { fs::create_directory(to / "no" / "deeper"); }),
            (around / "made/").string() + ": cannot write: No such file or directory");
}

TEST(UnitOutputFolder, KeepsWhatOthersHavePutBesideItsFiles) {
  const testing::TemporaryFolder around;
  const auto make = [&](bool meanwhile) {
    OutputFolder out(around / "made");
    write_text(out.temporary() / "mark", "");
    if (meanwhile) write_text(around / "made" / "thesis.tex", "years");
    out.commit();
  };
  make(false);
  make(false);
  EXPECT_THROW(make(true), InputError);   // it comes while the folder is made …
  EXPECT_THROW(make(false), InputError);  // … or is there before
  EXPECT_EQ(read_text(around / "made" / "thesis.tex"), "years");
}

TEST(UnitOutputFolder, ReplacesNoFileThatWasRead) {
  const testing::TemporaryFolder around;
  const auto make = [&] {
    OutputFolder out(around / "made");
    write_text(out.temporary() / "mesh.ply", "");
    out.commit();
  };
  make();
  const ProtectedInputs inputs;
  read_text(around / "made" / "mesh.ply");
  EXPECT_THROW(make(), InputError);
}

TEST(UnitOutputFolder, RemovesWhatAKilledProcessHasLeft) {
  const testing::TemporaryFolder around;
  fs::create_directory(around / ".made.folder-1");
  write_text(around / ".made.folder-1" / "mark", "");
  const OutputFolder living(around / "made");
  EXPECT_FALSE(fs::exists(around / ".made.folder-1"));
}

}  // namespace
}  // namespace pellucid
