// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/command_line.h"

namespace pellucid::app {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

TEST_F(UnitCommandLine, TracesASurfaceAndPicturesItsError) {
  const fs::path mesh = folder_ / "s.ply", picture = folder_ / "s.png";
  const std::string trace =
      "trace --field formula:u=-y,v=x,w=0 --integrator fixed-front:particles=3,rows=10 "
      "--seed 1,0,0:1,0,1 --duration 3 --json --quiet -o " +
      mesh.string();
  const Outcome outcome = run(trace + " --error-picture " + picture.string());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("\"triangles\": 40"));
  EXPECT_THAT(read_text(mesh), HasSubstr("property double error\n"));
  EXPECT_TRUE(fs::is_regular_file(picture));
  fs::remove(mesh);
  fs::remove(picture);
  EXPECT_THAT(refusal(trace + " --against hultquists --error-picture " + picture.string()),
              HasSubstr("unknown integrator 'hultquists'"));
  EXPECT_THAT(refusal(trace + " --samples 0 --error-picture " + picture.string()),
              HasSubstr("--error-picture"));
}

/// Along z all sheets keep their shape: what is let go for 2 units of time is 2 long.
TEST_F(UnitCommandLine, TracesStreakAndTimeSurfaces) {
  write_text(folder_ / "mesh.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
  const std::string up =
      "trace --field formula:u=0,v=0,w=1 --duration 2 --samples 50 --json --quiet -o " +
      (folder_ / "s.vtp").string() + " ";
  const std::string streak = up + "--integrator streak-surface:particles=5 ";
  const std::string time = up + "--integrator time-surface:particles=5 ";
  const std::vector<std::pair<std::string, std::string>> calls{
      {streak + "--seed 0,0,0:1,0,0", "2"},
      {streak + "--seeds circle:center=0,0,0,radius=1,normal=0,0,1", "2"},
      {time + "--seeds patch:corner=0,0,0,u=1,0,0,v=0,1,0", "0"},
      {time + "--seeds sphere:center=0,0,0,radius=1", "0"},
      {time + "--seeds " + (folder_ / "mesh.obj").string(), "0"}};
  for (const auto& [call, tallest] : calls) {
    const Outcome outcome = run(call);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const auto json = nlohmann::json::parse(outcome.out);
    // The tolerance is a thousandth of the seeds' extent, which is below 4.
    EXPECT_LE(json["distance"]["max"], 4e-3) << call;
    EXPECT_LE(json["distance"]["max_from_surface"], 4e-3) << call;
    EXPECT_EQ(json["sheets"], 1) << call;
  }
  EXPECT_THAT(refusal(time + "--seed 0,0,0:1,0,0"), HasSubstr("accepted of a time surface"));
  EXPECT_THAT(refusal(time + "--seeds patch:corner=0,0,0,u=1,0,0,v=2,0,0"), HasSubstr("patch"));
  EXPECT_THAT(refusal(streak + "--seeds grid:from=0,0,0,to=1,1,0,count=3,2,1"),
              HasSubstr("no curve"));
  EXPECT_THAT(refusal(streak + "--seed 0,0,0:1,0,0 --both"), HasSubstr("--both"));
}

/// p = (x + 2 y + 4 z) / 4, which trilinear interpolation keeps.
TEST_F(UnitCommandLine, CarriesAttributesOfAFileAlong) {
  std::string flow =
      "# vtk DataFile Version 3.0\nflow\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 2 2\n"
      "ORIGIN 0 0 0\nSPACING 4 4 4\nPOINT_DATA 8\nSCALARS p float 1\nLOOKUP_TABLE default\n"
      "0 1 2 3 4 5 6 7\nVECTORS U float\n";
  for (int i = 0; i < 8; ++i) flow += "0 1 0\n";
  write_text(folder_ / "flow.vtk", flow);
  const std::string field = (folder_ / "flow.vtk").string(), lines = (folder_ / "l.vtp").string();
  const std::string call =
      "trace --field " + field + " --seed 1,0,1:2,0,1 --json --quiet -o " + lines + " --duration ";
  const Outcome outcome = run(call + "2 --integrator stream-lines:particles=2 --carry p");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto carried = nlohmann::json::parse(outcome.out)["carried"]["p"];
  EXPECT_NEAR(carried["min"], 1.25, 1e-6);
  EXPECT_NEAR(carried["max"], 2.5, 1e-6);
  EXPECT_EQ(carried["without_value"], 0);
  EXPECT_THAT(run("info " + lines).out, ContainsRegex("'p'.*1\\.25"));
  fs::remove(lines);
  EXPECT_THAT(refusal(call + "2 --integrator hultquist --carry T"),
              AllOf(HasSubstr("no scalar 'T'"), HasSubstr("p (point")));
  EXPECT_THAT(refusal("trace --field abc --seed 1,0,1:2,0,1 --integrator hultquist --duration 1 "
                      "--carry p -o " +
                      lines),
              HasSubstr("it has no scalar 'p'"));
  for (const char* ending : {".obj", ".tck"})
    EXPECT_THAT(
        refusal("trace --field " + field +
                " --seed 1,0,1:2,0,1 --duration 1 --integrator "
                "stream-lines:particles=2 --carry p -o " +
                (folder_ / ("l" + std::string(ending))).string()),
        AllOf(HasSubstr("files hold no 'p' of --carry; accepted: .ply"), HasSubstr(".vtp")));
  // A scene's colours ask for them by name, whatever draws the surface, and back in time.
  const auto scene = [&](const std::string& by, const std::string& duration) {
    write_text(folder_ / "scene.json",
               R"({"format": "pellucid-scene", "version": 1, "resolution": [60, 60], "objects": [
                   {"surface": {"field": "flow.vtk", "integrator": "hultquist", "duration": )" +
                   duration + R"(, "seed": {"from": [1, 2, 1], "to": [2, 2, 1]}},
                    "opacity": 0.5, "color": {"by": ")" +
                   by + R"(", "range": [1.25, 2.5]}}]})");
    return (folder_ / "scene.json").string();
  };
  for (const char* duration : {"1.5", "-1.5"})
    for (const char* method : {"raytrace", "linked-list", "tree"}) {
      const std::string file = (folder_ / (std::string(method) + ".exr")).string();
      const Outcome drawn =
          run("render " + scene("p", duration) + " -m " + method + " --quiet -o " + file);
      ASSERT_EQ(drawn.exit_code, 0) << method << drawn.err;
      const Outcome compared =
          run("compare " + (folder_ / "raytrace.exr").string() + " " + file + " --json");
      // The tree's lines are strips, whose borders differ by 0.03; by t it would be 0.2.
      EXPECT_LE(double(nlohmann::json::parse(compared.out)["rmse"]), 0.05) << method;
    }
  EXPECT_THAT(refusal("render " + scene("T", "1") + " -m raytrace --quiet -o " +
                      (folder_ / "t.png").string()),
              AllOf(HasSubstr("no scalar 'T'"), HasSubstr("what is integrated has s, speed, t")));
}

/// Of lines every seed is a line; z = 0 stays so, since the flow goes along z.
TEST_F(UnitCommandLine, TracesFromSeedsOfEveryKind) {
  write_text(folder_ / "p.csv", "x,y,z\n0,0,0\n1,0,0\n1,1,0\n");
  write_text(folder_ / "open.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nl 1 2 3\n");
  write_text(folder_ / "closed.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nl 1 2 3 1\n");
  write_text(folder_ / "two.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nl 1 2\nl 2 3\n");
  write_text(folder_ / "mesh.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
  const std::string up = "trace --field formula:u=0,v=0,w=1 --duration 2 --json --quiet ";
  const std::string to_lines = " -o " + (folder_ / "l.vtp").string() + " --seeds ";
  const std::string lines = up + "--integrator stream-lines:particles=4" + to_lines;
  const std::string one_each = up + "--integrator stream-lines" + to_lines;
  const std::string surface = up + "--samples 0 --integrator fixed-front:particles=25,rows=2 -o " +
                              (folder_ / "s.vtp").string() + " --seeds ";
  const auto of_file = [&](const char* name) { return (folder_ / name).string(); };
  const std::string circle = "circle:center=1,2,3,radius=1,normal=0,0,2";
  const std::string grid = "grid:from=0,0,0,to=1,1,0,count=3,2,1";
  const std::vector<std::pair<std::string, int>> line_counts{{lines + circle, 4},
                                                             {one_each + grid, 6},
                                                             {one_each + of_file("p.csv"), 3},
                                                             {lines + of_file("open.obj"), 4},
                                                             {one_each + of_file("mesh.obj"), 3}};
  for (const auto& [call, count] : line_counts) {
    const Outcome outcome = run(call);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(nlohmann::json::parse(outcome.out)["lines"], count) << call;
  }
  // An open curve has a border all around, a closed one two.
  const std::vector<std::pair<std::string, int>> borders{{circle, 2 * 25},
                                                         {of_file("closed.obj"), 2 * 27},
                                                         {of_file("p.csv") + " --closed", 2 * 27},
                                                         {of_file("p.csv"), 2 * 24 + 4},
                                                         {of_file("open.obj"), 2 * 24 + 4}};
  for (const auto& [seeds, edges] : borders) {
    const Outcome outcome = run(surface + seeds);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(nlohmann::json::parse(outcome.out)["boundary_edges"], edges) << seeds;
  }
  fs::remove(folder_ / "l.vtp");
  fs::remove(folder_ / "s.vtp");
  EXPECT_THAT(refusal(surface + grid), HasSubstr("a grid is no curve"));
  EXPECT_THAT(refusal(lines + of_file("two.obj")), HasSubstr("two.obj: it holds 2 polylines"));
  EXPECT_THAT(refusal(lines + of_file("none.csv")), HasSubstr("none.csv"));
  EXPECT_THAT(refusal(lines + circle + " --closed"), HasSubstr("--closed"));
  EXPECT_THAT(refusal(lines + circle + " --seed 0,0,0"), HasSubstr("both are given"));
  EXPECT_THAT(refusal(lines.substr(0, lines.rfind("--seeds"))), HasSubstr("neither is given"));
  EXPECT_THAT(refusal(lines + "circle:center=1,2,radius=1,normal=0,0,1"),
              HasSubstr("center=1,2; accepted: three finite numbers"));
  EXPECT_THAT(refusal(lines + "circle:centre=1,2,3"), HasSubstr("known: center, radius, normal"));
  EXPECT_THAT(refusal(lines + "grid:from=0,0,0,to=1,1,1"), HasSubstr("'count' is missing"));
  EXPECT_THAT(refusal(lines + "grid:from=0,0,0,to=1,1,1,count=9,9,0.5"), HasSubstr("9,9,0.5"));
}

TEST_F(UnitCommandLine, RefusesWhatATraceWouldIgnore) {
  const std::string trace = "trace --field formula:u=0,v=0,w=1 --duration 2 --quiet -o " +
                            (folder_ / "l.vtp").string() + " --seed 0,0,0:1,0,0 --integrator ";
  EXPECT_THAT(refusal(trace + "stream-lines --path"),
              AllOf(HasSubstr("--path: stream-lines"), HasSubstr("path-lines")));
  for (const char* samples : {"-1", "100000001", "2.5"})
    EXPECT_THAT(refusal(trace + "fixed-front --samples " + samples), HasSubstr("--samples"));
  EXPECT_THAT(refusal(trace + "stream-lines --samples 50"), HasSubstr("with a surface"));
  const std::string at_points = "trace --field formula:u=0,v=0,w=1 --duration 2 --quiet -o " +
                                (folder_ / "l.vtp").string() +
                                " --seeds grid:from=0,0,0,to=1,1,1,count=2,2,2 --integrator ";
  EXPECT_THAT(refusal(at_points + "stream-lines:particles=9"), HasSubstr("particles=9"));
}

TEST_F(UnitCommandLine, RefusesScenesOfFlowsThatEndUnfinished) {
  const std::string flow = R"({"field": "abc", "seed": {"from": [0, 0, 0], "to": [1, 0, 0]},
                              "duration": 2, "integrator": )";
  struct Cut {
    std::string object, integrator, budget;
  };
  for (const auto& [object, integrator, budget] :
       {Cut{"surface", "hultquist:max-triangles=20", "max-triangles"},
        Cut{"surface", "hultquist:tolerance=1e-4,max-particles=20", "max-particles"},
        Cut{"surface", "hultquist:max-steps=3", "max-steps"},
        Cut{"lines", "stream-lines:particles=4,max-vertices=20", "max-vertices"},
        Cut{"lines", "stream-lines:particles=4,max-steps=3", "max-steps"}}) {
    write_text(scene(), R"({"format": "pellucid-scene", "version": 1, "objects": [{")" + object +
                            "\": " + flow + '"' + integrator + "\"}}]}");
    EXPECT_THAT(refusal(render("raytrace")), HasSubstr("unfinished: " + budget)) << integrator;
  }
}

TEST_F(UnitCommandLine, TracesAgainstTime) {
  // (x, y) = (x₀ exp t, y₀ exp -t): the line's last point is at t = -1, or at 1 and its first at
  // -1.
  const fs::path file = folder_ / "l.obj";
  const std::string trace = "trace --field saddle --seed 1,1,0 -o " + file.string() +
                            " --integrator stream-lines:particles=1 --quiet";
  EXPECT_EQ(run(trace + " --duration -1").exit_code, 0);
  EXPECT_THAT(read_text(file), HasSubstr("v 0.36787944"));
  EXPECT_THAT(read_text(file), ::testing::Not(HasSubstr("v 2.7182818")));
  EXPECT_EQ(run(trace + " --duration 1 --both").exit_code, 0);
  EXPECT_THAT(read_text(file), AllOf(HasSubstr("v 0.36787944"), HasSubstr("v 2.7182818")));
  fs::remove(file);
  EXPECT_THAT(refusal(trace + " --duration 0"), HasSubstr("duration"));
  // A surface's sheet goes the other way, and is as good.
  const fs::path mesh = folder_ / "s.obj";
  const std::string surface =
      "trace --field formula:u=1,v=0,w=0 --seed 0,0,0:0,1,0 --duration -2 "
      "--integrator fixed-front:particles=3,rows=4 --json --quiet -o " +
      mesh.string();
  const Outcome outcome = run(surface);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_LE(json["distance"]["max"], 1e-9);
  EXPECT_LE(json["normal_degrees"]["max"], 1e-6);
  EXPECT_THAT(read_text(mesh), ContainsRegex("v -(2|1[.]99999999999999[0-9]*) "));  // four steps
  fs::remove(mesh);
  EXPECT_THAT(refusal(surface + " --both"), HasSubstr("--both"));
}

TEST_F(UnitCommandLine, TraceMeasuresASurfaceAgainstAnotherRun) {
  const std::string trace =
      "trace --field formula:u=-y,v=x,w=0 --integrator fixed-front:particles=3,rows=10 "
      "--seed 1,0,0:1,0,1 --duration 3 --json --quiet -o " +
      (folder_ / "s.ply").string();
  const Outcome outcome = run(trace + " --against hultquist:tolerance=1e-3");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("\"integrator\": \"hultquist:tolerance=1e-3\""));
  EXPECT_THAT(outcome.out, HasSubstr("\"from_other\""));
  fs::remove(folder_ / "s.ply");
  EXPECT_THAT(refusal(trace + " --samples 0 --against hultquist"), HasSubstr("--against"));
}

}  // namespace
}  // namespace pellucid::app
