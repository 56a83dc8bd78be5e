// SPDX-License-Identifier: GPL-3.0-or-later
// A limit of a file's size, as shells and clusters set it, fails like a disk that is full.
#include "tests/app/command_line.h"

namespace pellucid::app {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class UnitSizeLimit : public UnitCommandLine {
 protected:
  /// What the program says when its files may take no more than 1024 bytes: of the two programs of
  /// this line the limit holds for the second.
  std::string said(const std::string& arguments) const {
    return refusal("--version >/dev/null; ulimit -f 2; exec " PELLUCID_PROGRAM " " + arguments, 1);
  }
  std::string on_scene(const std::string& command, const std::string& options) const {
    return command + ' ' + scene().string() + " --quiet " + options;
  }
  std::string file(const std::string& name) const { return (folder_ / name).string(); }
};

TEST_F(UnitSizeLimit, WhatIsWrittenFailsByOneLineAndLeavesNothing) {
  for (const std::string& call :
       {render("raytrace", "a.exr"), render("raytrace", "a.png"),
        on_scene("render", "-m raytrace --deep " + file("d.exr")),
        on_scene("render", "-m raytrace --deep " + file("d.npz")),
        on_scene("render", "-m fourier --partial " + file("s.exr")),
        on_scene("frames", "-m raytrace --orbit 9 --frames 2 -o " + file("f")),
        on_scene("export", "-o " + file("e")), "conform --only layers-1 --make " + file("c")})
    EXPECT_THAT(said(call), AllOf(HasSubstr("File too large"), Not(HasSubstr(".folder-")))) << call;
}

}  // namespace
}  // namespace pellucid::app
