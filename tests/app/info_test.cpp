// SPDX-License-Identifier: GPL-3.0-or-later
// `pellucid info`: what files of known content are said to hold.

#include <gmock/gmock.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/files/output_file.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using ::testing::HasSubstr;

class UnitInfo : public ::testing::Test {
 protected:
  struct Outcome {
    int exit_code;
    std::string out, err;
  };

  Outcome run(const std::string& arguments) const {
    const fs::path out = folder_ / "stdout", err = folder_ / "stderr";
    const std::string command = "cd " + folder_.path().string() + " && " + PELLUCID_PROGRAM + " " +
                                arguments + " >" + out.string() + " 2>" + err.string();
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_text(out), read_text(err)};
  }
  Json info(const std::string& file, const std::string& content = "") const {
    if (!content.empty()) write_text(folder_ / file, content);
    const Outcome outcome = run("info " + file + " --json --quiet");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return Json::parse(outcome.out, nullptr, false);
  }

  testing::TemporaryFolder folder_;
};

Json array_of(const Json& info, const std::string& name) {
  for (const Json& array : info.at("arrays"))
    if (array.at("name") == name) return array;
  ADD_FAILURE() << name << " is not among " << info.at("arrays");
  return {};
}

/// Two cells; vectors at points, of which one number is no number, and bytes at cells.
constexpr const char* image = R"(<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian">
<ImageData WholeExtent="0 2 0 1 0 1" Origin="1 2 3" Spacing="0.5 1 2"><Piece Extent="0 2 0 1 0 1">
<PointData><DataArray type="Float32" Name="v" NumberOfComponents="3" format="ascii">
0 0 0 1 -1 0 2 0 0 3 0 0 4 0 0 5 0 7 6 0 0 7 0 0 8 0 0 9 0 0 10 0 0 nan 0 0
</DataArray></PointData><CellData>
<DataArray type="UInt8" Name="region" format="ascii">3 200</DataArray></CellData>
</Piece></ImageData></VTKFile>
)";

TEST_F(UnitInfo, AnImageHasItsLatticeAndItsArraysAtPointsAndCells) {
  const Json json = info("a.vti", image);
  EXPECT_EQ(json["kind"], "image");
  EXPECT_EQ(json["bounds"], Json::parse(R"({"min": [1, 2, 3], "max": [2, 3, 5]})"));
  EXPECT_EQ(json["counts"], Json::parse(R"({"points": 12, "cells": 2})"));
  EXPECT_EQ(json["dimensions"], Json({3, 2, 2}));
  EXPECT_EQ(json["spacing"], Json({0.5, 1, 2}));
  const Json v = array_of(json, "v"), region = array_of(json, "region");
  EXPECT_EQ(v["at"], "point");
  EXPECT_EQ(v["components"], 3);
  EXPECT_EQ(v["type"], "float");
  EXPECT_EQ(v["count"], 12);
  EXPECT_EQ(v["ranges"], Json::parse("[[0, 10], [-1, 0], [0, 7]]"));
  EXPECT_EQ(v["not_finite"], 1);
  EXPECT_EQ(region["at"], "cell");
  EXPECT_EQ(region["type"], "unsigned char");
  EXPECT_EQ(region["ranges"], Json::parse("[[3, 200]]"));
}

TEST_F(UnitInfo, PointsThatAreNowhereAreCounted) {
  const Json json =
      info("n.vtp",
           R"(<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian"><PolyData>
<Piece NumberOfPoints="3" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="0">
<Points><DataArray type="Float32" NumberOfComponents="3" format="ascii">0 0 0 nan 0 0 0 1 inf
</DataArray></Points></Piece></PolyData></VTKFile>)");
  EXPECT_EQ(json["points not finite"], 2);
}

TEST_F(UnitInfo, RangesHaveTheDigitsThatTellTheirEndsApart) {
  write_text(folder_ / "r.csv", "x,y,z,p\n0,0,1e6,101325\n1,0,1000000.25,101325.04\n");
  const std::string text = run("info r.csv --quiet").out;
  EXPECT_THAT(text, HasSubstr("bounds: (0, 0, 1000000) … (1, 0, 1000000.25)\n"));
  EXPECT_THAT(text, HasSubstr("101325 … 101325.04\n"));
}

TEST_F(UnitInfo, VerticesThatNothingIsDrawnOfAreCounted) {
  const Json json = info("far.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 9 9 9\nf 1 2 3\n");
  EXPECT_EQ(json["bounds"]["max"], Json({1, 1, 0}));
  EXPECT_EQ(json["counts"]["points"], 4);
  EXPECT_EQ(json["remarks"], Json({"1 of 4 vertices are of no triangle, and are left out"}));
}

TEST_F(UnitInfo, ASeriesHasItsTimesAndWhatItsFirstFileHolds) {
  info("a.vti", image);
  const Json json = info("a.vti.series",
                         R"({"file-series-version": "1.0", "files": [{"name": "a.vti", "time": 0.5},
          {"name": "a.vti", "time": 2}]})");
  EXPECT_EQ(json["times"], Json({0.5, 2}));
  EXPECT_EQ(array_of(json, "v")["count"], 12);
}

/// Which vectors would be a velocity is nobody's question here.
TEST_F(UnitInfo, ACollectionOfFilesWithTwoVectorsHasItsTimes) {
  std::string two = image;
  const std::string vectors =
      two.substr(two.find("<DataArray type=\"Float32\""),
                 two.find("</PointData>") - two.find("<DataArray type=\"Float32\""));
  std::string other = vectors;
  other.replace(other.find("\"v\""), 3, "\"w\"");
  two.insert(two.find("</PointData>"), other);
  info("two.vti", two);
  const Json json = info("c.pvd", R"(<VTKFile type="Collection"><Collection>
      <DataSet timestep="3" file="two.vti"/><DataSet timestep="1" file="two.vti"/></Collection></VTKFile>)");
  EXPECT_EQ(json["kind"], "files over time");
  EXPECT_EQ(json["times"], Json({1, 3}));
  EXPECT_EQ(json["counts"]["files"], 2);
  EXPECT_EQ(array_of(json, "w")["count"], 12);
}

TEST_F(UnitInfo, AMetaImageHasItsNumbers) {
  const Json json = info("a.mha",
                         "NDims = 3\nDimSize = 2 1 2\nElementType = MET_UCHAR\n"
                         "Offset = 1 2 3\nElementDataFile = LOCAL\nabcd");
  EXPECT_EQ(json["dimensions"], Json({2, 1, 2}));
  EXPECT_EQ(array_of(json, "MetaImage")["ranges"], Json::parse("[[97, 100]]"));
}

TEST_F(UnitInfo, GeometryTellsWhatItIsDrawnAs) {
  const std::string vertices =
      "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "property float speed\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n";
  const std::string values = "0 0 0 5 255 0 0\n1 0 0 6 255 0 51\n0 1 4 -7 255 0 0\n";
  const Json mesh = info("mesh.ply", "ply\nformat ascii 1.0\n" + vertices +
                                         "element face 1\nproperty list uchar int vertex_indices\n"
                                         "end_header\n" +
                                         values + "3 0 1 2\n");
  EXPECT_EQ(mesh["kind"], "triangles");
  EXPECT_EQ(mesh["counts"], Json::parse(R"({"points": 3, "triangles": 1})"));
  EXPECT_EQ(mesh["bounds"], Json::parse(R"({"min": [0, 0, 0], "max": [1, 1, 4]})"));
  EXPECT_EQ(array_of(mesh, "speed")["ranges"], Json::parse("[[-7, 6]]"));
  EXPECT_EQ(array_of(mesh, "colors")["components"], 4);
  EXPECT_EQ(array_of(mesh, "colors")["ranges"][0], Json({1, 1}));
  const Json lines = info("lines.ply", "ply\nformat ascii 1.0\n" + vertices +
                                           "element edge 2\nproperty int vertex1\n"
                                           "property int vertex2\nend_header\n" +
                                           values + "0 1\n1 2\n");
  EXPECT_EQ(lines["kind"], "lines");
  EXPECT_EQ(lines["counts"], Json::parse(R"({"points": 3, "lines": 1, "segments": 2})"));
  const Json points =
      info("points.ply", "ply\nformat ascii 1.0\n" + vertices + "end_header\n" + values);
  EXPECT_EQ(points["kind"], "points");
  EXPECT_EQ(info("p.csv", "x,y,z,w\n1,2,3,4\n")["counts"], Json::parse(R"({"points": 1})"));
}

TEST_F(UnitInfo, ASceneHasItsObjectsItsCameraAndItsSize) {
  info("p.csv", "x,y,z,w\n0,0,0,4\n2,0,0,8\n");
  const Json json = info("scene.json", R"({"format": "pellucid-scene", "version": 1,
      "resolution": [64, 32], "lighting": "phong", "camera": {"eye": [1, 0, 9]},
      "objects": [{"points": "p.csv", "radius": 0.5, "opacity": 0.25, "name": "two"}]})");
  EXPECT_EQ(json["kind"], "scene");
  EXPECT_EQ(json["resolution"], Json({64, 32}));
  EXPECT_EQ(json["camera"]["eye"], Json({1, 0, 9}));
  EXPECT_EQ(json["bounds"], Json::parse(R"({"min": [-0.5, -0.5, -0.5], "max": [2.5, 0.5, 0.5]})"));
  EXPECT_EQ(json["counts"]["points"], 2);
  ASSERT_EQ(json["objects"].size(), 1u);
  EXPECT_EQ(json["objects"][0]["name"], "two");
  EXPECT_EQ(json["objects"][0]["holds"], "2 points");
  EXPECT_EQ(json["objects"][0]["scalars"], Json({"w"}));
  EXPECT_EQ(json["objects"][0]["opacities"], Json({0.25, 0.25}));
}

TEST_F(UnitInfo, RadiiThatDifferAreARange) {
  info("p.csv", "x,y,z,r\n0,0,0,0.5\n2,0,0,1\n1,0,0,0.25\n");
  const Json json = info("scene.json", R"({"format": "pellucid-scene", "version": 1,
      "objects": [{"points": "p.csv", "radius": {"by": "r"}}, {"points": "p.csv", "radius": 2}]})");
  EXPECT_EQ(json["objects"][0]["radius"], Json({0.25, 1}));
  EXPECT_EQ(json["objects"][0]["bounds"],
            Json::parse(R"({"min": [-0.5, -1, -1], "max": [3, 1, 1]})"));
  EXPECT_EQ(json["objects"][1]["radius"], 2);
}

TEST_F(UnitInfo, APictureHasItsSizeAndItsChannels) {
  info("p.csv", "x,y,z\n0,0,0\n");
  info("scene.json", R"({"format": "pellucid-scene", "version": 1, "resolution": [6, 4],
                         "objects": [{"points": "p.csv", "radius": 1, "color": [1, 0, 0]}]})");
  ASSERT_EQ(run("render scene.json -m raytrace -o a.exr --quiet").exit_code, 0);
  const Json json = info("a.exr");
  EXPECT_EQ(json["kind"], "picture");
  EXPECT_EQ(json["counts"]["width"], 6);
  EXPECT_EQ(json["counts"]["height"], 4);
  EXPECT_EQ(array_of(json, "R")["ranges"][0], Json({1, 1}));
  EXPECT_EQ(array_of(json, "G")["ranges"][0], Json({0, 1}));
  EXPECT_EQ(array_of(json, "G")["count"], 24);
}

TEST_F(UnitInfo, ADeepPictureSaysWhatItIsOf) {
  info("p.csv", "x,y,z\n0,0,0\n0,0,1\n");
  info("scene.json", R"({"format": "pellucid-scene", "version": 1, "resolution": [6, 4],
                         "camera": {"type": "orthographic", "eye": [0, 0, 9], "height": 2},
                         "objects": [{"points": "p.csv", "radius": 9, "color": [1, 0, 0]}]})");
  ASSERT_EQ(run("render scene.json -m raytrace --part 2/2 --deep a.exr --quiet").exit_code, 0);
  const Json json = info("a.exr");
  EXPECT_EQ(json["kind"], "deep picture");
  EXPECT_EQ(json["counts"], Json({{"width", 6}, {"height", 4}, {"crossings", 24}}));
  EXPECT_EQ(json["scene"], "scene");
  EXPECT_EQ(json["part"], Json({2, 2}));
}

TEST_F(UnitInfo, PeopleAreToldTheSame) {
  info("a.vti", image);
  const Outcome outcome = run("info a.vti");
  EXPECT_THAT(outcome.out, HasSubstr("image (VTK image)\n  bounds: (1, 2, 3) … (2, 3, 5)\n"));
  EXPECT_THAT(outcome.out,
              HasSubstr("point array 'v': 3 × float, 0 … 10; -1 … 0; 0 … 7, 1 not finite\n"));
}

/// Six digits of 4500000.25 are those of 4500002.5.
TEST_F(UnitInfo, EndsFarFromTheOriginAreToldApart) {
  info("far.csv", "x,y,z,t\n4500000.25,0,1e6,7\n4500002.5,1,1000001,7\n");
  const Outcome outcome = run("info far.csv");
  EXPECT_THAT(outcome.out,
              HasSubstr("bounds: (4500000.25, 0, 1000000) … (4500002.5, 1, 1000001)\n"));
  EXPECT_THAT(outcome.out, HasSubstr("'t': 1 × double, 7 … 7"));
}

TEST_F(UnitInfo, CamerasOfASceneCanBePastedIntoIt) {
  std::string points = "x,y,z\n0,0,0\n2,0,0\n0,1,0\n0,0,90\n";
  for (int i = 0; i < 60; ++i) points += "1,1,1\n";  // so that the one far away is less than 2 %
  info("p.csv", points);
  const std::string scene = R"({"format": "pellucid-scene", "version": 1, "resolution": [40, 30],
      "objects": [{"points": "p.csv", "radius": 0.5, "opacity": 0.5}])";
  write_text(folder_ / "scene.json", scene + "}");
  const Outcome outcome = run("info scene.json --cameras 3 -o views.png --json --quiet");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  ASSERT_EQ(json["views"].size(), 3u);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "views.png"));
  const Json camera = json["views"][0]["camera"];
  EXPECT_NE(camera, json["views"][1]["camera"]);
  EXPECT_EQ(json["outliers"][0]["vertices"], 1);
  write_text(folder_ / "again.json", scene + ", \"camera\": " + camera.dump() + "}");
  EXPECT_EQ(Json::parse(run("info again.json --json --quiet").out)["camera"], camera);
  EXPECT_THAT(run("info scene.json --cameras 2").out, HasSubstr("\"camera\": {"));
}

TEST_F(UnitInfo, CamerasOfNothingAreRefused) {
  info("p.csv", "x,y,z\n0,0,0\n");
  write_text(folder_ / "scene.json", R"({"format": "pellucid-scene", "version": 1,
      "objects": [{"points": "p.csv", "radius": 0.5, "opacity": 0}]})");
  for (const auto& [call, said] :
       {std::pair("info scene.json --cameras 0", "--cameras"),
        std::pair("info p.csv --cameras 3", "p.csv"),
        std::pair("info scene.json -o a.png", "--cameras"),
        std::pair("info scene.json --cameras 3 -o a.gif", "accepted: .pdf, .svg, .png"),
        std::pair("info scene.json --cameras 3", "nothing of the scene is seen"),
        std::pair("info none.json --cameras 3", "none.json")}) {
    const Outcome outcome = run(std::string(call) + " --quiet");
    EXPECT_EQ(outcome.exit_code, 2) << call;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(said));
  }
}

TEST_F(UnitInfo, TheRestIsRefusedInOneLine) {
  write_text(folder_ / "a.txt", "text");
  write_text(folder_ / "study.json", R"({"format": "pellucid-study", "version": 1})");
  for (const auto& [file, said] :
       {std::pair("a.txt", "unknown kind of file '.txt'; accepted: .json (scenes), .ply"),
        std::pair("none.ply", "none.ply: cannot read"), std::pair("study.json", "format")}) {
    const Outcome outcome = run(std::string("info ") + file + " --quiet");
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(said));
    EXPECT_EQ(outcome.out, "");
  }
}

}  // namespace
}  // namespace pellucid::app
