// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The command line as scripts see it: exit codes, one line on stderr, nothing half written.

#include <gmock/gmock.h>
#include <sys/wait.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "core/files/output_file.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::app {

namespace fs = std::filesystem;

/// An Outcome is how a run of the program ended, and what it printed.
struct Outcome {
  int exit_code;
  std::string out, err;
};

/// Runs the program in a folder with a scene of one sheet.
class UnitCommandLine : public ::testing::Test {
 protected:
  void SetUp() override {
    write_text(folder_ / "sheet.ply",
               "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
               "property float z\nproperty float alpha\nelement face 1\n"
               "property list uchar int vertex_indices\nend_header\n"
               "-1 -1 0 0.5\n1 -1 0 0.25\n0 1 0 0.75\n3 0 1 2\n");
    write_text(scene(), R"({"format": "pellucid-scene", "version": 1, "resolution": [96, 96],
                            "objects": [{"mesh": "sheet.ply"}]})");
  }
  void TearDown() override { fs::permissions(folder_.path(), fs::perms::owner_all); }

  fs::path scene() const { return folder_ / "scene.json"; }

  Outcome run(const std::string& arguments) const {
    const fs::path out = folder_ / "stdout", err = folder_ / "stderr";
    const std::string command = std::string(PELLUCID_PROGRAM) + " " + arguments + " >" +
                                out.string() + " 2>" + err.string();
    const int status = std::system(command.c_str());
    Outcome outcome{WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_text(out), read_text(err)};
    fs::remove(out);
    fs::remove(err);
    return outcome;
  }

  /// Runs what must be refused: exit code `code`, one line on stderr, no new file.
  std::string refusal(const std::string& arguments, int code = 2) const {
    const auto files = [&] { return std::distance(fs::directory_iterator(folder_.path()), {}); };
    const auto before = files();
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, code) << arguments << ": " << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_EQ(files(), before) << arguments;
    return outcome.err;
  }

  /// What `list` can list, from its message about what it cannot.
  std::vector<std::string> known_listings() const {
    const std::string message = refusal("list x"), mark = "known: ";
    std::stringstream known(message.substr(message.find(mark) + mark.size()));
    std::vector<std::string> names;
    for (std::string name; known >> name;)
      names.push_back(name.back() == ',' ? name.substr(0, name.size() - 1) : name);
    return names;
  }

  std::string render(const std::string& method, const std::string& output = "a.png") const {
    return "render " + scene().string() + " --quiet -m " + method + " -o " +
           (folder_ / output).string();
  }

  testing::TemporaryFolder folder_;
};

}  // namespace pellucid::app
