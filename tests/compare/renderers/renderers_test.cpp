// SPDX-License-Identifier: GPL-3.0-or-later
// What a list of renderers may hold, and what is written of them.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "compare/pictures/image_file.h"
#include "compare/renderers/renderers_report.h"
#include "core/error.h"
#include "core/files/json_text.h"
#include "core/files/output_file.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::compare {
namespace {

using pellucid::testing::TemporaryFolder;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class UnitRenderers : public ::testing::Test {
 protected:
  RendererList read(const std::string& renderers) {
    write_text(folder_ / "list.json", R"({"title": "What?", "renderers": )" + renderers + "}");
    return read_renderer_list(folder_ / "list.json");
  }
  std::string refusal(const std::string& renderers) {
    try {
      read(renderers);
    } catch (const InputError& error) {
      return error.what();
    }
    return "nothing was refused";
  }
  std::vector<RendererResult> conform(const std::string& renderers) {
    return conform_all(read(renderers), {.call = {}, .only = "layers-1"});
  }
  TemporaryFolder folder_;
};

TEST_F(UnitRenderers, AreMethodsProgramsAndFolders) {
  std::filesystem::create_directory(folder_ / "drawn");
  const RendererList list = read(R"([
    "weighted-average", {"pictures": "drawn", "name": "mine"},
    {"external": "shell", "command": ["/bin/sh", "-c", "exit 3 # {output}"]}])");
  EXPECT_EQ(list.title, "What?");
  ASSERT_EQ(list.renderers.size(), 3u);
  EXPECT_EQ(list.renderers[0].name, "weighted-average");
  EXPECT_EQ(list.renderers[1].pictures, folder_ / "drawn");
  EXPECT_EQ(list.renderers[2].name, "shell");
  for (const ListedRenderer& renderer : list.renderers)
    EXPECT_THAT(renderer.left_out, IsEmpty()) << renderer.name;
}

TEST_F(UnitRenderers, RefuseWhatTheListCannotMean) {
  EXPECT_THAT(refusal("[]"), HasSubstr("renderers: is empty"));
  EXPECT_THAT(refusal(R"(["raytrace", "raytrace"])"),
              AllOf(HasSubstr("renderers[1]"), HasSubstr("there twice")));
  EXPECT_THAT(refusal(R"([{"external": "x"}])"), HasSubstr("lacks \"command\""));
  EXPECT_THAT(refusal(R"([{"pictures": "drawn"}])"), HasSubstr("name"));
  EXPECT_THAT(refusal(R"([{"external": "x", "command": ["/bin/sh", "-c", "{scene}"]}])"),
              HasSubstr("{output}"));
}

/// Nobody has all programs: what is not there is said, and the others are asked.
TEST_F(UnitRenderers, AreLeftOutWhereTheyAreNotThere) {
  const auto results = conform(R"([
    {"external": "gone", "command": ["no-such-program", "{output}"]},
    {"pictures": "nowhere", "name": "no folder"},
    {"external": "fails", "command": ["/bin/sh", "-c", "echo lacks a module >&2; exit 3 # {output}"]},
    "raytrace"])");
  EXPECT_THAT(results[0].nothing_drawn(), HasSubstr("no program that may be run"));
  EXPECT_THAT(results[1].nothing_drawn(), HasSubstr("nowhere: no folder"));
  EXPECT_THAT(results[2].nothing_drawn(), HasSubstr("lacks a module"));
  EXPECT_THAT(results[3].nothing_drawn(), IsEmpty());
  EXPECT_EQ(results[3].passed(), 1u);
}

/// Eight bits are no fault, nor the right picture.
TEST_F(UnitRenderers, CountWhatEightBitsHoldApart) {
  std::filesystem::create_directory(folder_ / "drawn");
  for (const ConformanceCase& c : conformance_cases()) {
    if (c.name != "layers-1") continue;
    Image image = displayed_values(expected_picture(c));
    for (Rgba& pixel : image.pixels) pixel.r += 1 / 255.f;
    write_image(folder_ / "drawn" / "layers-1.png", image, {});
  }
  const auto results = conform(R"([{"pictures": "drawn", "name": "a step off"}])");
  EXPECT_EQ(results[0].passed(), 0u);
  EXPECT_EQ(results[0].right_to_two_steps(), 1u);
}

TEST_F(UnitRenderers, ReportShowsAllPicturesOnAPageWithoutScripts) {
  const auto results = conform(R"([
    "raytrace", "weighted-average",
    {"external": "<script>\"&", "command": ["no-such-program", "{output}"]}])");
  write_renderers_report(folder_.path(), {"<b>", 0.5}, results);
  const std::string page = read_text(folder_ / "report.html");
  EXPECT_THAT(page, AllOf(HasSubstr("<title>&lt;b&gt;</title>"), HasSubstr("1 of 1"),
                          HasSubstr("more than 0.5"), HasSubstr("&lt;script&gt;&quot;&amp;"),
                          Not(HasSubstr("<script"))));
  std::size_t pictures = 0;
  for (std::size_t at = 0; (at = page.find("<img ", at)) != page.npos; ++at) ++pictures;
  EXPECT_EQ(pictures, 3u);  // right, and of the two that drew
  EXPECT_THAT(read_text(folder_ / "table.md"),
              AllOf(HasSubstr("| layers-1 | passed | passed |"), HasSubstr("drew nothing")));
  const nlohmann::json json = read_json(folder_ / "results.json");
  EXPECT_EQ(json["renderers"].size(), 3u);
  EXPECT_EQ(json["renderers"][1]["cases"][0]["name"], "layers-1");
  EXPECT_TRUE(json["renderers"][2].contains("drew_nothing"));
}

}  // namespace
}  // namespace pellucid::compare
