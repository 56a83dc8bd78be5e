// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/options/lower_case.h"
#include "tests/app/command_line.h"

namespace pellucid::app {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

TEST_F(UnitCommandLine, RendersAndWritesStatistics) {
  const Outcome outcome = run(render("raytrace") + " --stats " + (folder_ / "s.json").string() +
                              " --layers " + (folder_ / "layers.exr").string() + " --explain");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out, HasSubstr("nothing is lit"));
  EXPECT_TRUE(fs::exists(folder_ / "a.png"));
  EXPECT_TRUE(fs::exists(folder_ / "layers.exr"));
  for (const char* key :
       {"\"method\"", "\"seconds\"", "\"bytes\"", "\"fragments\"", "\"max_layers\"", "\"machine\""})
    EXPECT_THAT(read_text(folder_ / "s.json"), HasSubstr(key));
}

TEST_F(UnitCommandLine, ProbesPixels) {
  const std::string file = (folder_ / "p.json").string();
  const Outcome outcome =
      run(render("raytrace") + " --probe 48,48 --probe 0,0 --probe-out " + file);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string json = read_text(file);
  EXPECT_THAT(json, AllOf(HasSubstr("\"optical_depth\""), HasSubstr("\"importance_sum\""),
                          HasSubstr("\"layers\": []")));
  EXPECT_THAT(refusal(render("raytrace") + " --probe 96,0 --probe-out " + file + "2"),
              HasSubstr("95,95"));
  for (const char* pixel : {"1,2,3", "1", "1,", ",", "1,2.5", "1,2,3,4", "1;2"})
    EXPECT_THAT(refusal(render("raytrace") + " --probe '" + pixel + "' --probe-out " + file + "2"),
                AllOf(HasSubstr(pixel), HasSubstr("X,Y")));
}

TEST_F(UnitCommandLine, WritesExactSumsAndDeepPictures) {
  const auto sums = folder_ / "sums.exr", deep = folder_ / "deep.exr";
  const Outcome outcome =
      run(render("fourier") + " --sums " + sums.string() + " --deep " + deep.string());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(fs::exists(sums));
  EXPECT_TRUE(fs::exists(deep));
}

TEST_F(UnitCommandLine, EndingsAreCheckedBeforeAnyWork) {
  for (const char* option : {"--sums", "--deep"})
    EXPECT_THAT(refusal(render("raytrace") + ' ' + option + ' ' + (folder_ / "x.png").string()),
                HasSubstr("'.png'; accepted: .exr"));
  EXPECT_THAT(refusal(render("raytrace") + " --layers " + (folder_ / "x.jpg").string()),
              HasSubstr("'.jpg'; accepted: .exr, .png"));
}

/// NaN is above no bound and below none: it would switch off what it is given for.
TEST_F(UnitCommandLine, NoOptionTakesWhatIsNoNumber) {
  const std::string seed = " --seed 0,0,0:1,0,0 -o x.ply",
                    trace = "trace --field abc --integrator ";
  for (const std::string& call : {std::string("conform -m raytrace --tolerance"),
                                  std::string("conform -m raytrace --timeout"),
                                  std::string("figure results -o x.pdf --font-size"),
                                  "tune " + scene().string() + " --max-rmse",
                                  "tune " + scene().string() + " --max-rmse 0.1 --max-seconds",
                                  trace + "hultquist" + seed + " --duration",
                                  trace + "hultquist" + seed + " --duration 1 --start-time",
                                  "frames " + scene().string() + " -m raytrace -o x --orbit",
                                  std::string("compare a b --fail-rmse")})
    for (const char* number : {"nan", "inf"}) EXPECT_NE(refusal(call + " " + number), "") << call;
}

TEST_F(UnitCommandLine, UnknownNamesOfferTheNearest) {
  EXPECT_THAT(refusal(render("furier")), HasSubstr("unknown method 'furier'; known: fourier"));
  EXPECT_THAT(refusal(render("fourier:band=3")), HasSubstr("unknown key 'band'; known: bands"));
  EXPECT_THAT(refusal(render("raytrace:precision=high")), HasSubstr("accepted: exact|double"));
  EXPECT_THAT(refusal("list method"), HasSubstr("unknown listing 'method'; known: methods"));
  EXPECT_THAT(refusal("rendr x"), HasSubstr("unknown command 'rendr'; known: render"));
  refusal("");
}

TEST_F(UnitCommandLine, WrongScenesAreRefused) {
  EXPECT_THAT(refusal("render none.json -m raytrace -o " + (folder_ / "a.png").string()),
              HasSubstr("none.json: cannot read"));
  write_text(folder_ / "sheet.ply", read_text(folder_ / "sheet.ply").substr(0, 200));
  EXPECT_THAT(refusal(render("raytrace")),
              AllOf(HasSubstr("sheet.ply"), HasSubstr("objects[0].mesh")));
  write_text(scene(), "{}");
  EXPECT_THAT(refusal(render("raytrace")), HasSubstr("'format' is missing"));
}

/// What only the drawing finds out names the scene's file as what its reading finds does.
TEST_F(UnitCommandLine, ScenesThatCannotBeDrawnAreRefusedByTheirFile) {
  const std::string head = R"({"format": "pellucid-scene", "version": 1, "resolution": [16, 16], )";
  write_text(folder_ / "tetrahedron.obj",
             "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  for (const char* rest :
       {R"("camera": {"eye": [0, 0, -5], "target": [0, 0, -9], "fov": 40},
           "objects": [{"mesh": "sheet.ply"}]})",
        R"("objects": [{"points": "sheet.ply", "radius": 1e300}]})",
        R"("objects": [{"isosurface": {"dataset": "sphere-levels", "scalar": "q", "value": 0.02,
           "hole": {"mesh": "tetrahedron.obj", "distance": 0.1}}}]})"}) {
    write_text(scene(), head + rest);
    EXPECT_THAT(refusal(render("linked-list")), HasSubstr("scene.json: ")) << rest;
  }
}

TEST_F(UnitCommandLine, OutputsThatCannotBeWrittenAreRefused) {
  EXPECT_THAT(refusal(render("raytrace", "none/a.png")), HasSubstr("cannot write"));
  EXPECT_THAT(refusal(render("raytrace", "a.bmp2")), HasSubstr("a.bmp2"));
}

TEST_F(UnitCommandLine, AFullDiskIsAFailureOfTheWork) {
  const fs::path mount = folder_ / "full";
  fs::create_directory(mount);
  if (std::system(("mount -t tmpfs -o size=4k tmpfs " + mount.string() + " 2>/dev/null").c_str()))
    GTEST_SKIP() << "may not mount a file system here";
  EXPECT_THAT(refusal(render("raytrace", "full/a.exr"), 1), HasSubstr("full/a.exr"));
  EXPECT_TRUE(fs::is_empty(mount));
  EXPECT_EQ(std::system(("umount " + mount.string()).c_str()), 0);
}

TEST_F(UnitCommandLine, ListsEveryTableAsJsonToo) {
  const auto listings = known_listings();
  EXPECT_GE(listings.size(), 12u);
  for (const std::string& what : listings) {
    const Outcome text = run("list " + what);
    EXPECT_EQ(text.exit_code, 0) << text.err;
    std::set<std::string> names;
    for (const nlohmann::json& row : nlohmann::json::parse(run("list --json " + what).out)) {
      const std::string name = row.at("name"), title = row.at("title");
      EXPECT_TRUE(names.insert(name).second) << what << ' ' << name;
      EXPECT_FALSE(name.empty() || title.empty()) << what << ' ' << name;
      EXPECT_THAT(text.out, HasSubstr(name + "   " + title + '\n')) << what;
    }
    EXPECT_FALSE(names.empty()) << what;
  }
}

TEST_F(UnitCommandLine, ListsOneRowByItsName) {
  for (const std::string& what : known_listings()) {
    const auto rows = nlohmann::json::parse(run("list --json " + what).out);
    const std::string name = rows.back().at("name");
    EXPECT_EQ(nlohmann::json::parse(run("list --json " + what + ' ' + name).out),
              nlohmann::json::array({rows.back()}))
        << what;
    EXPECT_THAT(refusal("list " + what + ' ' + name + "~"),
                HasSubstr("'" + name + "~'; known: " + name));
  }
}

TEST_F(UnitCommandLine, WritesDataThatDrawTheSamePicture) {
  const auto isosurface = [&](const std::string& data) {
    write_text(scene(), R"({"format": "pellucid-scene", "version": 1, "resolution": [40, 24],
        "objects": [{"isosurface": {)" +
                            data +
                            R"(, "scalar": "q", "value": 0.05}, "color": {"by": "speed"},
                             "opacity": 0.5}]})");
  };
  const std::string name = "sphere-levels:levels=2,rings=2";
  const Outcome outcome = run("data " + name + " -o " + (folder_ / "wake.vdb").string());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("56"));  // samples of the coarsest level along x: 14 / 0.25
  isosurface(R"("dataset": ")" + name + "\"");
  ASSERT_EQ(run(render("raytrace", "generated.exr")).exit_code, 0);
  isosurface(R"("file": "wake.vdb")");
  ASSERT_EQ(run(render("raytrace", "read.exr")).exit_code, 0);
  EXPECT_THAT(run("compare " + (folder_ / "generated.exr").string() + " " +
                  (folder_ / "read.exr").string() + " --json")
                  .out,
              HasSubstr("\"max_error\": 0.0"));
}

TEST_F(UnitCommandLine, NamesBothPicturesThatCannotBeCompared) {
  ASSERT_EQ(run(render("raytrace", "a.exr")).exit_code, 0);
  std::string smaller = read_text(scene());
  smaller.replace(smaller.find("[96, 96]"), 8, "[12, 8]");
  write_text(scene(), smaller);
  ASSERT_EQ(run(render("raytrace", "b.png")).exit_code, 0);
  const Outcome outcome =
      run("compare " + (folder_ / "a.exr").string() + " " + (folder_ / "b.png").string());
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err,
              AllOf(HasSubstr("b.png against "), HasSubstr("a.exr: test picture: 12×8")));
}

TEST_F(UnitCommandLine, WritesDataOfEveryKindAndRefusesOthers) {
  for (const char* call : {"data stack:layers=2 -o ", "data trefoil:count=3 -o "})
    EXPECT_EQ(run(call + (folder_ / "a.ply").string()).exit_code, 0) << call;
  EXPECT_EQ(run("data ctbl:count=50 -o " + (folder_ / "points.ply").string()).exit_code, 0);
  EXPECT_THAT(read_text(folder_ / "points.ply"), HasSubstr("element vertex 50\n"));
  const std::string vdb = (folder_ / "b.vdb").string();
  EXPECT_THAT(refusal("data sphere-level -o " + vdb), HasSubstr("known: sphere-levels"));
  EXPECT_THAT(refusal("data ctbl:count=50 -o " + vdb), HasSubstr("accepted for ctbl: .ply"));
  EXPECT_THAT(refusal("data sphere-levels -o " + (folder_ / "b.ply").string()),
              HasSubstr("accepted for sphere-levels: .vdb"));
  EXPECT_THAT(refusal("data sphere-levels:rings=-1 -o " + vdb), HasSubstr("rings"));
}

TEST_F(UnitCommandLine, TunesWithinABoundAndSaysWhenNothingIs) {
  const std::string tune =
      "tune " + scene().string() + " --quiet --repeats 1 --methods 'raytrace,march,linked-list' ";
  const Outcome outcome = run(tune + "--max-rmse 1e-4");  // one layer: most methods are exact
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("pellucid render"));
  EXPECT_THAT(outcome.out, HasSubstr("left out: without an isosurface it draws as raytrace does"));
  const Outcome few = run("tune " + scene().string() +
                          " --max-rmse 1e-4 --json --methods 'raytrace*,linked-list'"
                          " --region covered --max-seconds 60");
  EXPECT_EQ(few.exit_code, 0) << few.err;
  EXPECT_THAT(few.err, HasSubstr("5 settings compete, about "));
  EXPECT_THAT(few.out, AllOf(HasSubstr("\"cheapest\""), HasSubstr("\"tied\""),
                             HasSubstr("\"rmse_covered\"")));
  EXPECT_THAT(refusal("tune " + scene().string() + " --max-rmse 1 --methods furier"),
              HasSubstr("fits no method"));
  EXPECT_THAT(refusal(tune + "--max-rmse 1 --region cover"), HasSubstr("covered"));
  EXPECT_THAT(refusal(tune + "--max-rmse 1 --max-seconds 0"), HasSubstr("--max-seconds"));
  EXPECT_THAT(refusal(tune + "--max-rmse 1e-4 --max-bytes 1", 1), HasSubstr("no method"));
  for (const char* bytes : {"-1", "99999999999999999999999", "x"})
    EXPECT_THAT(refusal(tune + "--max-rmse 1 --max-bytes " + bytes), HasSubstr("--max-bytes"));
  EXPECT_THAT(refusal(tune), HasSubstr("accepted: --max-rmse"));
}

TEST_F(UnitCommandLine, RendersFramesOfAPath) {
  const std::string call = "frames " + scene().string() + " --quiet -m linked-list ";
  const std::string into = "-o " + (folder_ / "frames").string();
  EXPECT_THAT(refusal(call + into), HasSubstr("no camera_path"));
  EXPECT_THAT(refusal(call + into + " --orbit 10 --frames 1"), HasSubstr("frames"));
  const Outcome outcome = run(call + into + " --orbit 10 --frames 3 --json");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("\"picture_change\""));
  for (const char* file : {"0000.png", "0002.png", "frames.csv"})
    EXPECT_TRUE(fs::exists(folder_ / "frames" / file)) << file;
  EXPECT_THAT(read_text(folder_ / "frames" / "frames.csv"), HasSubstr("\n2,4.6"));
  const Outcome compared = run(call + into + " --orbit 10 --frames 3 --json --reference raytrace");
  EXPECT_EQ(compared.exit_code, 0) << compared.err;
  EXPECT_THAT(compared.out, AllOf(HasSubstr("\"rmse\""), HasSubstr("\"flicker\"")));
  EXPECT_THAT(read_text(folder_ / "frames" / "frames.csv"), HasSubstr(",seconds,rmse,"));
  EXPECT_EQ(run(call + into + " --orbit 10 --frames 2").exit_code, 0);
  EXPECT_FALSE(fs::exists(folder_ / "frames" / "0002.png"));  // of another camera's film
  write_text(folder_ / "frames" / "0003.png", "somebody's own");
  EXPECT_THAT(refusal(call + into + " --orbit 10 --frames 2"), HasSubstr("'0003.png'"));
  fs::remove(folder_ / "frames" / "0003.png");
  EXPECT_THAT(refusal(call + into + " --orbit 10 --reference raytrac"), HasSubstr("raytrace"));
  EXPECT_THAT(refusal("frames " + scene().string() + " -m decoupled --orbit 10 " + into +
                      " --reference raytrace"),
              HasSubstr("accepted: --opacities"));
}

TEST_F(UnitCommandLine, CompletionOffersWhatIsAccepted) {
  const std::string script = run("--completion bash").out;
  const std::size_t at = script.find("--opacities) candidates='");
  ASSERT_NE(at, std::string::npos);
  const std::string line = script.substr(at, script.find('\n', at) - at);
  EXPECT_THAT(line, HasSubstr("fourier-opacity"));
  EXPECT_THAT(line, ::testing::Not(HasSubstr("depth-peeling")));
}

/// What is asked of the camera holds for each key of a path, or is refused: never passed over.
TEST_F(UnitCommandLine, ThePathsKeysTakeWhatIsAskedOfTheCamera) {
  write_text(scene(), R"({"format": "pellucid-scene", "version": 1, "resolution": [24, 24],
    "objects": [{"mesh": "sheet.ply"}], "camera_path": {"frames": 2, "keys":
    [{"eye": [0, 0, 5], "fov": 30}, {"eye": [3, 0, 4], "fov": 40}]}})");
  const std::string call = "frames " + scene().string() + " --quiet -m raytrace -o " +
                           (folder_ / "frames").string() + " ";
  const auto frame = [&](const char* name) { return read_text(folder_ / "frames" / name); };
  ASSERT_EQ(run(call + "--camera target=0,0.25,0,fov=20").exit_code, 0);
  EXPECT_THAT(frame("0000.png"), HasSubstr("eye=0,0,5,target=0,0.25,0,up=0,1,0,fov=20"));
  EXPECT_THAT(frame("0001.png"), HasSubstr("eye=3,0,4,target=0,0.25,0,up=0,1,0,fov=20"));
  for (const char* asked : {"--view +x", "--camera eye=0,0,9"})
    EXPECT_THAT(refusal(call + asked), AllOf(HasSubstr("camera_path"), HasSubstr("--orbit")));
  EXPECT_EQ(run(call + "--view +x --orbit 10 --frames 2").exit_code, 0);
  EXPECT_EQ(run(render("raytrace") + " --view +x").exit_code, 0);  // which follows no path
}

/// Embree flushes denormal numbers while it builds a mesh's hierarchy; lines step by them.
TEST_F(UnitCommandLine, ASceneAfterAnyOtherEqualsItselfAlone) {
  const std::vector<std::string> names = {"mesh", "lines", "points"};
  const std::vector<std::string> objects = {
      R"({"mesh": "sheet.ply"})", R"({"dataset": "benzene:count=12,seed=1", "radius": 0.05})",
      R"({"dataset": "dark-sky:count=500,seed=1", "radius": 0.01})"};
  for (std::size_t i = 0; i < names.size(); ++i)
    write_text(
        folder_ / (names[i] + ".json"),
        R"({"format": "pellucid-scene", "version": 1, "resolution": [48, 36], "objects": [)" +
            objects[i] + "]}");
  write_text(folder_ / "study.json", R"({"format": "pellucid-study", "version": 1,
    "scenes": ["mesh.json", "lines.json", "points.json"], "reference": "raytrace",
    "methods": ["linked-list"], "repeats": 1})");
  ASSERT_EQ(run("study " + (folder_ / "study.json").string() + " --quiet -o " +
                (folder_ / "whole").string())
                .exit_code,
            0);
  for (const std::string& name : names) {
    const fs::path own = folder_ / ("only-" + name);
    ASSERT_EQ(run("study " + (folder_ / "study.json").string() + " --quiet -o " + own.string() +
                  " --only '" + name + "/*'")
                  .exit_code,
              0);
    for (const char* method : {"raytrace", "linked-list"}) {
      const fs::path picture = fs::path("images") / name / (std::string(method) + ".exr");
      EXPECT_EQ(read_text(folder_ / "whole" / picture), read_text(own / picture)) << picture;
    }
  }
}

/// The reader of the pipe is gone before anything is printed, as `head` may be at any time.
TEST_F(UnitCommandLine, WhoHasSeenEnoughIsNoFailure) {
  for (const char* what :
       {"list methods", "list methods --json", "list studies", "--help", "study extremes --plan"}) {
    const std::string err = (folder_ / "err").string();
    const std::string command = std::string("bash -c '(sleep 0.2; exec ") + PELLUCID_PROGRAM + " " +
                                what + " 2> " + err + ") | true; exit ${PIPESTATUS[0]}'";
    EXPECT_EQ(std::system(command.c_str()), 0) << what;
    EXPECT_EQ(read_text(err), "") << what;
  }
}

TEST_F(UnitCommandLine, HelpAndVersionExitWithZero) {
  for (const char* arguments :
       {"--help", "--version", "render --help", "study --help", "frames --help", "compare --help",
        "trace --help", "tune --help", "list --help"})
    EXPECT_EQ(run(arguments).exit_code, 0) << arguments;
}

TEST_F(UnitCommandLine, EveryCommandsHelpHasAnExample) {
  std::istringstream help(run("--help").out);
  std::string line;
  while (std::getline(help, line) && lower_case(line) != "subcommands:") {  // capitals in CLI11 2.5
  }
  int commands = 0;
  while (std::getline(help, line) && line.starts_with("  ")) {
    const std::string name = line.substr(2, line.find(' ', 2) - 2);
    if (name.empty()) continue;  // a description's second line
    EXPECT_THAT(run(name + " --help").out, HasSubstr("Example")) << name;
    ++commands;
  }
  EXPECT_GT(commands, 10);
}

TEST_F(UnitCommandLine, OneThreadGivesTheSamePicture) {
  EXPECT_EQ(run(render("raytrace", "a.exr")).exit_code, 0);
  EXPECT_EQ(run(render("raytrace", "b.exr") + " --threads 1").exit_code, 0);
  EXPECT_TRUE(read_text(folder_ / "a.exr") == read_text(folder_ / "b.exr"));
}

}  // namespace
}  // namespace pellucid::app
