// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "compare/report/report.h"
#include "compare/results/columns.h"
#include "compare/run/run_study.h"
#include "tests/compare/fake_methods.h"
#include "tests/compare/study_folder.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;
using namespace pellucid::compare::testing;

/// A study with a failing cell, and its report's text.
std::string make_report(const StudyFolder& folder) {
  const Study study =
      load_study(folder.study(R"(["shifted:by=0.5", "exact-shifted", "broken", "measuring"])"),
                 fake_methods());
  StudyOptions options;
  options.folder = folder / "results";
  run_study(study, options);
  return read_text(folder / "results/report.html");
}

std::size_t count(std::string_view text, std::string_view part) {
  std::size_t found = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size())
    ++found;
  return found;
}

std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t from = text.find(begin) + begin.size();
  return text.substr(from, text.find(end, from) - from);
}

/// Those of the whole picture, which the others are parts of.
std::size_t whole_metrics() {
  return std::size_t(std::ranges::count_if(metrics(), [](const MetricRow& row) {
    return row.region == Region::all && !row.on_request;
  }));
}

TEST(UnitReport, HoldsEveryRowAndPicture) {
  const StudyFolder folder;
  const std::string page = make_report(folder);
  const auto data = nlohmann::json::parse(
      between(page, R"(<script id="data" type="application/json">)", "</script>"));
  EXPECT_EQ(data["rows"].size(), 10u);
  EXPECT_THAT(data["rows"][4]["pictures"][0]["source"].get<std::string>(),
              ::testing::StartsWith("data:image/png;base64,iVBOR"));
  EXPECT_EQ(data["scenes"].size(), 2u);
  EXPECT_EQ(data["study"]["title"], "T & <t>");
  EXPECT_EQ(data["rows"][1]["metrics"]["rmse"], 0.5);
  EXPECT_THAT(data["rows"][1]["picture"].get<std::string>(),
              ::testing::StartsWith("data:image/png;base64,iVBOR"));
  EXPECT_THAT(data["rows"][3]["error"].get<std::string>(), HasSubstr("<more>"));
}

TEST(UnitReport, HoldsTheColumnsOfTheTable) {
  const StudyFolder folder;
  const auto data = nlohmann::json::parse(
      between(make_report(folder), R"(<script id="data" type="application/json">)", "</script>"));
  std::vector<std::string> expected, found;
  for (const Column& column : columns())
    if (column.shown.report) expected.push_back(column.name);
  for (const auto& column : data["columns"]) {
    found.push_back(column["name"]);
    EXPECT_TRUE(data["rows"][1]["values"].contains(found.back())) << found.back();
  }
  EXPECT_EQ(found, expected);
  EXPECT_EQ(data["metrics"].size(), whole_metrics());
  for (const auto& metric : data["metrics"])
    for (const char* of : {"space", "channels", "window"})
      EXPECT_FALSE(metric[of].get<std::string>().empty()) << metric["symbol"];
  EXPECT_THAT(data["rows"][1]["flip_map"].get<std::string>(),
              ::testing::StartsWith("data:image/png;base64,iVBOR"));
}

/// The page of a study with this title; its tables lie beside it.
std::string titled_report(const StudyFolder& folder, const std::string& title) {
  Study study = load_study(folder.study(R"(["shifted:by=0.5", "broken"])"), fake_methods());
  study.title = title;
  StudyOptions options;
  options.folder = folder / "results";
  run_study(study, options);
  return read_text(folder / "results/report.html");
}

/// Whatever a title says, the page reads it back, and no table runs it.
TEST(UnitReport, AnyTitleIsATitle) {
  const std::string ordinary = titled_report(StudyFolder(), "T");
  for (const std::string title :
       {"{{data}} {{css}}", "<!--<script>", "</script><script>alert(1)</script>", "a\n\\input{x}",
        "=cmd|' /C calc'!A0", "a | b | c", "\xE2\x80\xA8 \"quoted\" 'it'"}) {
    const StudyFolder folder;
    const std::string page = titled_report(folder, title);
    EXPECT_EQ(count(page, "<script"), count(ordinary, "<script")) << title;
    EXPECT_EQ(count(page, "<!--"), count(ordinary, "<!--")) << title;
    const auto data = nlohmann::json::parse(
        between(page, R"(<script id="data" type="application/json">)", "</script>"));
    EXPECT_EQ(data["study"]["title"], title);
    EXPECT_THAT(read_text(folder / "results/table.tex"), Not(HasSubstr("\n\\input"))) << title;
    EXPECT_THAT(read_text(folder / "results/table.md"), Not(HasSubstr("<script"))) << title;
  }
}

/// One file where all of it stays below the limit; without floats where only they go beyond it;
/// else a folder, in which each picture's floats are a script of their own.
TEST(UnitReport, TakesTheFormThatFits) {
  const StudyFolder folder;
  const Study study = load_study(folder.study(R"(["shifted:by=0.5"])"), fake_methods());
  StudyOptions options;
  options.folder = folder / "results";
  const auto rows = run_study(study, options).rows;
  const auto page = [&](std::size_t most_bytes) {
    write_report(options.folder, study, rows, {.most_bytes = most_bytes});
    return read_text(folder / "results/report.html");
  };
  const std::string whole = page(60'000'000);
  EXPECT_THAT(whole, HasSubstr("<script type=\"text/plain\" id=\"pixels-0\">"));
  EXPECT_FALSE(fs::exists(folder / "results/report"));
  const std::string without = page(whole.size() - 1000);  // the floats of four pictures take more
  EXPECT_THAT(without, HasSubstr("\"mantissa_bits\":"));
  EXPECT_LE(without.size(), whole.size() - 1000);
  const std::string linked = page(100'000);  // Vega alone is larger
  EXPECT_THAT(linked, HasSubstr("images/one/truth.png"));
  EXPECT_THAT(linked, Not(HasSubstr("data:image/png")));
  EXPECT_THAT(read_text(folder / "results/report/pixels-1.js"),
              HasSubstr("pellucidText(\"pixels-1\""));
  page(60'000'000);
  EXPECT_FALSE(fs::exists(folder / "results/report"));  // no more than the page needs
}

/// A name is a path to the system and a URL to the page.
TEST(UnitReport, PicturesOfAnySceneAreFound) {
  const StudyFolder folder;
  fs::copy_file(folder / "one.json", folder / "a?b#c%20.json");
  const fs::path file = folder.study(R"(["shifted:by=0.5"])");
  std::string text = read_text(file);
  text.replace(text.find("one.json"), 8, "a?b#c%20.json");
  write_text(file, text);
  const Study study = load_study(file, fake_methods());
  StudyOptions options;
  options.folder = folder / "results";
  const auto rows = run_study(study, options).rows;
  write_report(options.folder, study, rows, {.most_bytes = 100'000});
  const std::string page = read_text(folder / "results/report.html");
  EXPECT_THAT(page, HasSubstr("\"images/a%3Fb%23c%2520/truth.png\""));
  EXPECT_THAT(page, HasSubstr("\"images/two/truth.png\""));
}

TEST(UnitReport, TextCannotBecomeMarkup) {
  const StudyFolder folder;
  const std::string page = make_report(folder);
  EXPECT_THAT(page, HasSubstr("<title>T &amp; &lt;t&gt;</title>"));
  EXPECT_THAT(page, Not(HasSubstr("{{")));  // every mark was filled in
  EXPECT_EQ(count(page, "<script"), count(page, "</script>"));
}

/// What a command prints, and whether it succeeded.
std::pair<std::string, bool> output_of(const std::string& command) {
  std::FILE* pipe = ::popen(command.c_str(), "r");
  std::string text;
  char block[4096];
  for (std::size_t got; (got = std::fread(block, 1, sizeof block, pipe)) > 0;)
    text.append(block, got);
  return {text, ::pclose(pipe) == 0};
}

/// The page's own policy (no source but itself and data:) turns every request into a console error,
/// so that their absence proves both.
TEST(SlowReport, ABrowserShowsItWithoutErrorsOrRequests) {
  if (!output_of("command -v chromium").second) GTEST_SKIP() << "chromium is not installed";
  const StudyFolder folder;
  EXPECT_THAT(make_report(folder), HasSubstr("default-src 'none'"));
  const std::string log = (folder / "log").string();
  const auto [dom, worked] = output_of(
      "timeout 90 chromium --headless --no-sandbox --disable-gpu --disable-quic --no-first-run "
      "--disable-background-networking --disable-component-update --disable-sync "
      "--window-size=1400,8000 "  // as far as plots are drawn
      "--enable-logging=stderr --v=0 --virtual-time-budget=5000 --user-data-dir=" +
      (folder / "profile").string() + " --dump-dom file://" +
      (folder / "results/report.html").string() + " 2>" + log);
  ASSERT_TRUE(worked) << read_text(log);
  EXPECT_THAT(read_text(log), Not(HasSubstr("CONSOLE")));
  EXPECT_EQ(count(dom, "<figure class=\"card\""), 10u);
  EXPECT_EQ(count(dom, "class=\"marks\""), 2u * 4);  // Vega's own: four plots per scene
  // The table of all numbers and the one across scenes: a head, and a row for each cell or method.
  // Two scenes' tables of measures: a head, and a row for each of two. The card of metrics.
  EXPECT_EQ(count(dom, "<tr"), 1u + 10 + 1 + 4 + 2 * 3 + 1 + whole_metrics());
  EXPECT_EQ(count(dom, "class=\"further\""), 2u);
}

}  // namespace
}  // namespace pellucid::compare
