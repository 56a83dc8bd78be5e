// SPDX-License-Identifier: GPL-3.0-or-later
// A study cell by cell, each in a process of its own.
#include <fmt/format.h>

#include <map>

#include "tests/app/command_line.h"

namespace pellucid::app {
namespace {

using ::testing::HasSubstr;

using Line = std::vector<std::string>;

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts;
  std::stringstream stream(text);
  for (std::string part; std::getline(stream, part, at);) parts.push_back(part);
  return parts;
}

/// Times, and what is made of them.
bool is_time(const std::string& column) {
  return column.find("seconds") != column.npos || column.starts_with("ms") ||
         column.ends_with("_ms");
}

/// The fields of a table without quotes but those of times.
std::vector<Line> table_without_times(const fs::path& csv) {
  std::vector<Line> lines;
  const std::vector<std::string> texts = split(read_text(csv), '\n');
  const Line names = split(texts.front(), ',');
  for (const std::string& text : texts) {
    const Line fields = split(text, ',');
    Line& line = lines.emplace_back();
    for (std::size_t i = 0; i < fields.size(); ++i)
      if (!is_time(names.at(i))) line.push_back(fields[i]);
  }
  return lines;
}

std::map<std::string, std::string> files_below(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      files[fs::relative(entry.path(), folder).string()] = read_text(entry.path());
  return files;
}

/// A reference, a sweep, two views and a command that copies a picture.
class UnitStudyCells : public UnitCommandLine {
 protected:
  void SetUp() override {
    UnitCommandLine::SetUp();
    ASSERT_EQ(run(render("weighted-sum", "theirs.exr")).exit_code, 0);
    write_text(folder_ / "study.json", R"({"format": "pellucid-study", "version": 1,
      "scenes": ["scene.json"], "reference": "raytrace", "repeats": 1, "views": 2,
      "methods": [{"method": "fourier", "bands": [1, 2]},
                  {"external": "theirs", "command": ["cp", ")" +
                                           (folder_ / "theirs.exr").string() +
                                           R"(", "{output}"]}]})");
  }

  /// By one thread: ray tracing has memory for each that took part, which is chance for so few
  /// rays.
  std::string study(const std::string& more, const std::string& to = "cells") const {
    return fmt::format("study {} --threads 1 -o {} {}", (folder_ / "study.json").string(),
                       (folder_ / to).string(), more);
  }
  /// Runs commands of a shell all at once, and returns their exit codes as text.
  std::string at_once(const std::vector<std::string>& commands) const {
    std::string line;
    for (std::size_t i = 0; i < commands.size(); ++i)
      line += fmt::format("({} {} >/dev/null 2>>{}; echo $? >{}.{}) & ", PELLUCID_PROGRAM,
                          commands[i], (folder_ / "said").string(), (folder_ / "code").string(), i);
    std::system((line + "wait").c_str());
    std::string codes;
    for (std::size_t i = 0; i < commands.size(); ++i)
      codes += read_text(folder_ / fmt::format("code.{}", i)).substr(0, 1);
    return codes;
  }
};

TEST_F(UnitStudyCells, AnyNumberAtOnceGiveTheTableAndThePicturesOfOneRun) {
  ASSERT_EQ(run(study("--quiet", "whole")).exit_code, 0);
  std::vector<std::string> cells;
  for (const std::string& line : split(run(study("--plan")).out, '\n'))
    cells.push_back(nlohmann::json::parse(line)["cell"]);
  ASSERT_EQ(cells.size(), 4u);
  const auto command = [&](std::size_t i) { return study("--cell '" + cells[i] + "'"); };
  ASSERT_EQ(run(command(0)).exit_code, 0);
  EXPECT_EQ(at_once({command(3), command(3), command(2), command(1), command(0)}), "00000")
      << read_text(folder_ / "said");
  EXPECT_EQ(at_once({study("--collect"), study("--collect")}), "00");
  EXPECT_EQ(table_without_times(folder_ / "cells/results.csv"),
            table_without_times(folder_ / "whole/results.csv"));
  EXPECT_EQ(files_below(folder_ / "cells/images"), files_below(folder_ / "whole/images"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "cells"), {}),
            std::distance(fs::directory_iterator(folder_ / "whole"), {}));
}

TEST_F(UnitStudyCells, WhatIsMissingOrFailedIsOneLineAndExitCodeOne) {
  EXPECT_THAT(refusal(study("--collect"), 1), HasSubstr("none of the 4 cells"));
  EXPECT_THAT(refusal(study("--cell scene/theirs"), 1), HasSubstr("needs scene/raytrace"));
  EXPECT_THAT(refusal(study("--cell scene/their")),
              HasSubstr("unknown cell 'scene/their'; known: scene/theirs, "));
  ASSERT_EQ(run(study("--cell scene/raytrace")).exit_code, 0);
  fs::rename(folder_ / "theirs.exr", folder_ / "gone.exr");
  const Outcome failed = run(study("--cell scene/theirs"));
  EXPECT_EQ(failed.exit_code, 1);
  EXPECT_THAT(failed.err, HasSubstr("scene/theirs: "));
  const Outcome collected = run(study("--collect --json"));
  EXPECT_EQ(collected.exit_code, 1);
  EXPECT_EQ(nlohmann::json::parse(collected.out)["rows"].size(), 2u);
  EXPECT_THAT(collected.err,
              HasSubstr("pellucid: 2 of 4 cells are missing: scene/fourier:bands=1, "
                        "scene/fourier:bands=2; 1 of 4 cells failed, the first: scene/theirs: "));
}

/// Pictures, layers and maps: whatever a row of the table was made of.
TEST_F(UnitStudyCells, ACellThatHasLostAFileIsNotFinished) {
  const auto unfinished = [&] {
    std::string names;
    for (const std::string& line : split(run(study("--plan")).out, '\n'))
      if (const auto cell = nlohmann::json::parse(line); !cell["done"])
        names += cell["cell"].get<std::string>();
    return names;
  };
  ASSERT_EQ(run(study("--quiet")).exit_code, 0);
  EXPECT_EQ(unfinished(), "");
  const fs::path images = folder_ / "cells/images/scene";
  const std::string fourier = "fourier-bands-1.view-2";
  int lost = 0;
  for (const auto& [name, bytes] : files_below(images)) {
    if (!name.starts_with(fourier)) continue;
    fs::remove(images / name);
    EXPECT_EQ(unfinished(), "scene/fourier:bands=1") << name;
    write_text(images / name, bytes.substr(0, bytes.size() / 2));
    EXPECT_EQ(unfinished(), "scene/fourier:bands=1") << name;
    write_text(images / name, bytes);
    ++lost;
  }
  EXPECT_EQ(lost, 5);  // two pictures, layers, two maps
  const fs::path torn = images / "fourier-bands-2.exr";
  const std::string whole = read_text(torn);
  write_text(torn, whole.substr(0, 2000));
  const Outcome collected = run(study("--collect"));
  EXPECT_EQ(collected.exit_code, 1);
  EXPECT_THAT(collected.out, HasSubstr("3 cells collected"));
  EXPECT_THAT(collected.err, HasSubstr("fourier:bands=2 (there, but fourier-bands-2.exr is not"));
  ASSERT_EQ(run(study("--cell scene/fourier:bands=2 --resume")).exit_code, 0);
  EXPECT_EQ(read_text(torn), whole);
  fs::remove(images / "raytrace.layers.exr");
  ASSERT_EQ(run(study("--quiet --resume")).exit_code, 0);
  EXPECT_TRUE(fs::exists(images / "raytrace.layers.exr"));
}

TEST_F(UnitStudyCells, OneWayAtATime) {
  EXPECT_THAT(refusal(study("--plan --collect")), HasSubstr("--plan"));
  EXPECT_THAT(refusal(study("--cell scene/raytrace --only x")), HasSubstr("--only"));
  EXPECT_THAT(refusal(study("--collect --resume")), HasSubstr("--resume"));
}

}  // namespace
}  // namespace pellucid::app
