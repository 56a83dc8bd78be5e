// SPDX-License-Identifier: GPL-3.0-or-later
// The program finds what belongs to it relative to itself: copies, moved clones, installations.

#include <gmock/gmock.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>

#include "core/files/output_file.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::app {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* study = R"({"format": "pellucid-study", "version": 1, "title": "Mine",
  "scenes": ["../scenes/a.json"], "methods": ["weighted-average"]})";

class UnitOwnFiles : public ::testing::Test {
 protected:
  /// A copy of the program in a folder of the temporary one.
  fs::path copy_program(const fs::path& folder) const {
    fs::create_directories(folder_ / folder);
    fs::copy(PELLUCID_PROGRAM, folder_ / folder);
    return folder_ / folder / "pellucid";
  }
  void write(const fs::path& file, const std::string& text) const {
    fs::create_directories((folder_ / file).parent_path());
    write_text(folder_ / file, text);
  }
  void copy_helpers(const fs::path& folder) const {
    fs::create_directories(folder_ / folder);
    for (const char* name : {"pellucid-read-picture", "pellucid-read-oiio"})
      fs::copy(fs::path(PELLUCID_PROGRAM).parent_path() / name, folder_ / folder);
  }

  struct Outcome {
    int exit_code;
    std::string printed;
  };
  Outcome run(const fs::path& program, const std::string& arguments) const {
    const fs::path out = folder_ / "printed";
    const std::string command =
        "cd / && " + program.string() + " " + arguments + " >" + out.string() + " 2>&1";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_text(out)};
  }

  /// Nothing of the clone that built the program is told, and a picture can be read.
  void expect_whole(const fs::path& program) const {
    const Outcome studies = run(program, "list studies");
    EXPECT_THAT(studies.printed, AllOf(HasSubstr("mine   Mine"), Not(HasSubstr("quickstart"))));
    const std::string picture = PELLUCID_SOURCE_DIR "/docs/images/" + first_picture();
    const Outcome compared = run(program, "compare " + picture + " " + picture);
    EXPECT_EQ(compared.exit_code, 0) << compared.printed;
  }
  static std::string first_picture() {
    for (const auto& entry : fs::directory_iterator(PELLUCID_SOURCE_DIR "/docs/images"))
      if (entry.path().extension() == ".png") return entry.path().filename().string();
    return {};
  }

  testing::TemporaryFolder folder_;
};

TEST_F(UnitOwnFiles, AMovedCloneUsesItsOwn) {
  const fs::path program = copy_program("clone/build/release");
  copy_helpers("clone/build/release");
  write("clone/build/release/CMakeCache.txt", "");
  write("clone/studies/mine.json", study);
  expect_whole(program);
}

TEST_F(UnitOwnFiles, AnInstallationMayBeMoved) {
  const fs::path program = copy_program("usr/bin");
  copy_helpers("usr/libexec/pellucid");
  write("usr/share/pellucid/studies/mine.json", study);
  expect_whole(program);
  fs::rename(folder_ / "usr", folder_ / "opt");
  expect_whole(folder_ / "opt/bin/pellucid");
}

TEST_F(UnitOwnFiles, ALinkIsTheProgramBehindIt) {
  const fs::path program = copy_program("usr/bin");
  copy_helpers("usr/libexec/pellucid");
  write("usr/share/pellucid/studies/mine.json", study);
  fs::create_symlink(program, folder_ / "link");
  expect_whole(folder_ / "link");
}

TEST_F(UnitOwnFiles, WhatIsMissingIsSaid) {
  const fs::path program = copy_program("alone");
  const std::string picture = PELLUCID_SOURCE_DIR "/docs/images/" + first_picture();
  const Outcome compared = run(program, "compare " + picture + " " + picture);
  EXPECT_EQ(compared.exit_code, 1);
  EXPECT_THAT(compared.printed, HasSubstr("alone/pellucid-read-"));
  EXPECT_THAT(run(program, "study quickstart").printed, HasSubstr("unknown study 'quickstart'"));
}

}  // namespace
}  // namespace pellucid::app
