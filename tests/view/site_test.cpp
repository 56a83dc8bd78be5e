// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/site/site.h"

#include <algorithm>

#include "compare/methods/methods.h"
#include "core/error.h"
#include "scene/files/scene_file.h"
#include "tests/view/small_scene.h"
#include "view/site/results_files.h"

namespace pellucid::view {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class UnitSite : public SmallScene {
 protected:
  Answer get(std::string_view path) { return site().answer({"GET", "", "", "", "", ""}, path); }
  Answer post(std::string_view path, const std::string& body,
              const std::string& type = "application/json") {
    return site().answer({"POST", "", "", "", type, body}, path);
  }
  nlohmann::json posted(std::string_view path, const nlohmann::json& body) {
    const Answer answer = post(path, body.dump());
    EXPECT_EQ(answer.status, 200) << answer.body;
    return nlohmann::json::parse(answer.body);
  }
  Site& site() {
    if (!site_)
      site_ = std::make_unique<Site>(content_, "osmesa",
                                     [this](const std::string& line) { printed_.push_back(line); });
    return *site_;
  }
  /// The one line that a refusal is.
  static std::string error(const Answer& answer, int status = 400) {
    EXPECT_EQ(answer.status, status) << answer.body;
    const std::string line = nlohmann::json::parse(answer.body)["error"];
    EXPECT_THAT(line, Not(HasSubstr("\n")));
    return line;
  }

  SiteContent content_{{{file(), true}}, std::nullopt};
  std::vector<std::string> printed_;
  std::unique_ptr<Site> site_;
};

TEST_F(UnitSite, ServesThePageAndNothingElse) {
  EXPECT_EQ(get("").location, "scene/0/");
  EXPECT_EQ(get("scene/0/").type, "text/html; charset=utf-8");
  EXPECT_THAT(get("scene/0/view.js").body, HasSubstr("class Stage"));
  EXPECT_THAT(get("scene/0/view.css").body, HasSubstr("prefers-color-scheme: dark"));
  for (const char* path : {"scene/1/", "scene/0", "scene/x/", "scene/", "x", "report/report.html",
                           "scene/0/../../../etc/passwd", "scene/0/view.html",
                           "scene/0//etc/passwd", "scene/99999999999999999999/", "scene/-1/"})
    EXPECT_EQ(get(path).status, 404) << path;
}

// Each method of the table with all of its parameters, and the objects' controls.
TEST_F(UnitSite, TellsTheTables) {
  const auto known = nlohmann::json::parse(get("scene/0/scene").body);
  ASSERT_EQ(known["methods"].size(), compare::methods().size());
  for (std::size_t i = 0; i < compare::methods().size(); ++i) {
    const scene::MethodRow& row = compare::methods()[i];
    const nlohmann::json& told = known["methods"][i];
    EXPECT_EQ(told["name"], row.name);
    ASSERT_EQ(told["parameters"].size(), row.parameters.size());
    for (std::size_t k = 0; k < row.parameters.size(); ++k) {
      EXPECT_EQ(told["parameters"][k]["name"], row.parameters[k].name);
      EXPECT_EQ(told["parameters"][k]["default"], row.parameters[k].default_value);
      EXPECT_EQ(told["parameters"][k]["unit"], row.parameters[k].unit);
    }
  }
  std::vector<std::string> sheet, lines;
  for (const auto& control : known["objects"][0]["controls"]) sheet.push_back(control["name"]);
  for (const auto& control : known["objects"][1]["controls"]) lines.push_back(control["name"]);
  EXPECT_THAT(sheet, ::testing::ElementsAre("opacity", "map"));
  EXPECT_THAT(lines, ::testing::ElementsAre("opacity", "radius", "halo-width", "halo-depth"));
  EXPECT_EQ(known["may_save"], true);
}

TEST_F(UnitSite, WhatIsWrongWithAQuestionIsOneLine) {
  EXPECT_THAT(error(post("scene/0/frame", "{\"a\": ")), HasSubstr("request"));
  EXPECT_THAT(error(post("scene/0/frame", "[1]")), HasSubstr("object"));
  EXPECT_THAT(error(post("scene/0/frame", std::string(100000, '['))), HasSubstr("request"));
  EXPECT_THAT(error(post("scene/0/frame", "{}")), HasSubstr("camera"));
  EXPECT_THAT(error(post("scene/0/save", "{\"camera\": {}, \"file\": \"/tmp/x\"}")),
              HasSubstr("file"));
  EXPECT_THAT(error(post("scene/0/frame", "{}", "text/plain"), 415), HasSubstr("application/json"));
  EXPECT_THAT(error(post("scene/0/scene", "{}"), 405), HasSubstr("GET"));
  EXPECT_THAT(error(get("scene/0/save"), 405), HasSubstr("POST"));
  nlohmann::json request = state();
  request["methods"] = {"raytrace"};
  EXPECT_THAT(error(post("scene/0/frame", request.dump())), HasSubstr("page"));
}

TEST_F(UnitSite, DrawsAFrame) {
  nlohmann::json request = state();
  request["methods"] = {"raytrace"};
  request["page"] = "a";
  const Answer answer = post("scene/0/frame", request.dump());
  EXPECT_EQ(answer.status, 200) << answer.body;
  EXPECT_GT(answer.body.size(), 4u * 3 * 48 * 32);
}

TEST_F(UnitSite, SeesAllFromASide) {
  nlohmann::json request = state();
  request["view"] = "+x";
  const nlohmann::json camera = posted("scene/0/camera", request)["camera"];
  EXPECT_GT(camera["eye"][0], 1);
  EXPECT_NEAR(camera["eye"][1].get<double>(), camera["target"][1].get<double>(), 1e-9);
  request["view"] = "above";
  EXPECT_THAT(error(post("scene/0/camera", request.dump())), HasSubstr("+x"));
}

TEST_F(UnitSite, SavesTheCameraIntoTheSceneAndPrintsIt) {
  const nlohmann::json request{{"camera", {{"eye", {1, 2, 3}}, {"fov", 30}}}};
  posted("scene/0/save", request);
  EXPECT_EQ(scene::load_scene(file()).camera.eye, Vec3(1, 2, 3));
  const nlohmann::json printed = posted("scene/0/print", request);
  EXPECT_EQ(printed["text"], "eye=1,2,3,target=0,0,0,up=0,1,0,fov=30");
  EXPECT_THAT(printed_, Contains("--camera eye=1,2,3,target=0,0,0,up=0,1,0,fov=30"));
}

TEST_F(UnitSite, AddsTheCameraToTheStudy) {
  const nlohmann::json request{{"camera", {{"eye", {1, 2, 3}}, {"fov", 30}}}};
  EXPECT_THAT(error(post("scene/0/study", request.dump()), 403), HasSubstr("command line"));
  const fs::path study = folder_ / "study.json";
  write_text(study, R"({"title": "mine"})");
  content_.study = study;
  site_.reset();
  EXPECT_EQ(posted("scene/0/study", request)["views"], 1);
  EXPECT_EQ(posted("scene/0/study", request)["views"], 2);
  const nlohmann::json written = nlohmann::json::parse(read_text(study));
  EXPECT_EQ(written["views"][1]["eye"], nlohmann::json({1.0, 2.0, 3.0}));
  EXPECT_EQ(written["title"], "mine");
}

TEST_F(UnitSite, WritesOnlyWhatWasNamed) {
  content_.scenes[0].may_be_written = false;
  const nlohmann::json request{{"camera", {{"eye", {1, 2, 3}}}}};
  EXPECT_THAT(error(post("scene/0/save", request.dump()), 403), HasSubstr("command line"));
  EXPECT_EQ(scene::load_scene(file()).camera.eye, Vec3(0, 0, 4));
}

// Of a study's folder what lies in it, by no way what does not.
TEST_F(UnitSite, ShowsAReportAndNoFileBesideIt) {
  const fs::path results = folder_ / "results";
  fs::create_directories(results / "report");
  write_text(results / "report.html", "<head></head><main id=\"main\"></main>");
  write_text(results / "report" / "pixels-0.js", "pellucidText()");
  write_text(folder_ / "secret", "secret");
  fs::create_symlink(folder_ / "secret", results / "link");
  fs::create_directory_symlink(folder_.path(), results / "folder");
  content_ = results_content(results);
  content_.scenes.push_back({file(), false});
  EXPECT_EQ(get("").location, "report/report.html");
  EXPECT_THAT(get("report/report.html").body,
              AllOf(HasSubstr("<a href=\"../scene/0/\">small</a>"), HasSubstr("<main id")));
  EXPECT_EQ(get("report/report/pixels-0.js").body, "pellucidText()");
  for (const std::string& path :
       {std::string("report/../secret"), "report/" + (folder_ / "secret").string(),
        std::string("report/link"), std::string("report/folder/secret"), std::string("report/"),
        std::string("report/report"), std::string("report/report/../../secret"),
        std::string("report/absent")})
    EXPECT_EQ(get(path).status, 404) << path;
}

TEST_F(UnitSite, AFolderWithoutAReportIsRefused) {
  EXPECT_THROW(results_content(folder_.path()), InputError);
}

}  // namespace
}  // namespace pellucid::view
