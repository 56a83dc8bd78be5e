// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/study/study.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "compare/cells/cell.h"
#include "compare/methods/methods.h"
#include "core/error.h"
#include "tests/compare/fake_methods.h"
#include "tests/compare/study_error.h"
#include "tests/compare/study_folder.h"

namespace pellucid::compare {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using namespace pellucid::compare::testing;

std::vector<std::string> texts(const Study& study) {
  std::vector<std::string> result;
  for (const MethodCall& call : study.methods) result.push_back(call.text());
  return result;
}

Study load(const std::string& methods, const std::string& more = "") {
  const StudyFolder folder;
  return load_study(folder.study(methods, more), fake_methods());
}

std::string methods_error(const std::string& methods, const std::string& more = "") {
  return study_error(methods, more);
}

TEST(UnitStudy, ReadsWhatStandsInTheFile) {
  const StudyFolder folder;
  const Study study = load_study(
      folder.study(R"(["shifted"])",
                   R"("repeats": 7, "source": "Fig. 1", "crops": {"two": [1, 2, 3, 4]})"),
      fake_methods());
  EXPECT_EQ(study.name, "study");
  EXPECT_EQ(study.title, "T & <t>");
  EXPECT_EQ(study.source, "Fig. 1");
  EXPECT_THAT(study.scenes, ElementsAre(folder / "one.json", folder / "two.json"));
  EXPECT_EQ(study.reference.text(), "truth");
  EXPECT_EQ(study.repeats, 7);
  EXPECT_EQ(study.crops.at("two").height, 4);
}

TEST(UnitStudy, AListIsASweepAndSeveralAreAProduct) {
  const Study study = load(R"(["shifted:times=2",
      {"method": "shifted", "by": [0.125, 1], "how": ["up", "down"], "often": true}])");
  EXPECT_THAT(texts(study),
              ElementsAre("shifted:times=2", "shifted:by=0.125,how=up,often=on",
                          "shifted:by=0.125,how=down,often=on", "shifted:by=1,how=up,often=on",
                          "shifted:by=1,how=down,often=on"));
}

TEST(UnitStudy, OpacitiesMakeOtherCells) {
  const StudyFolder folder;
  const auto load = [&](const std::string& more) {
    write_text(folder / "optimized.json",
               R"({"format": "pellucid-study", "version": 1, "scenes": ["one.json"],
                   "reference": "raytrace", "methods": ["fourier"])" +
                   more + "}");
    return load_study(folder / "optimized.json", methods());
  };
  const auto fingerprint = [](const Study& study) {
    return cell_fingerprint(expand_cells(study)[1], study.reference, fixed_repeats(1), {});
  };
  const Study plain = load(""), optimized = load(R"(, "opacities": "decoupled-lists")"),
              smoother = load(R"(, "opacities": "decoupled-lists:smooth=30")");
  EXPECT_FALSE(plain.opacities);
  EXPECT_EQ(smoother.opacities->text(), "decoupled-lists:smooth=30");
  EXPECT_NE(fingerprint(plain), fingerprint(optimized));
  EXPECT_NE(fingerprint(optimized), fingerprint(smoother));
  // They are found for the samples of all calls, of those of other cells, too.
  const auto beside_adaptive = [&](const std::string& more) {
    Study study = load(more);
    study.methods.push_back(parse_call("raytrace:adaptive=4", methods()));
    return study;
  };
  EXPECT_NE(fingerprint(optimized),
            fingerprint(beside_adaptive(R"(, "opacities": "decoupled-lists")")));
  EXPECT_EQ(fingerprint(plain), fingerprint(beside_adaptive("")));
  const auto refused = [&](const std::string& more) {
    try {
      load(more);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_THAT(refused(R"(, "opacities": "fourier")"),
              HasSubstr("opacities: 'fourier' finds no opacities of vertices; accepted: "));
  EXPECT_THAT(refused(R"(, "opacities": "decoupled-lists", "reference_scene": "two.json")"),
              HasSubstr("accepted: one of the two"));
}

TEST(UnitStudy, NoCellIsThereTwice) {
  EXPECT_THAT(texts(load(R"(["shifted", "truth", {"method": "shifted"}, "shifted:by=0.5"])")),
              ElementsAre("shifted", "shifted:by=0.5"));
}

/// The first one names the cell.
TEST(UnitStudy, OneNumberWrittenInSeveralWaysIsOneCell) {
  EXPECT_THAT(texts(load(R"(["shifted:by=0.5", "shifted:by=0.50", "shifted:by=+5e-1",
                             {"method": "shifted", "by": [0.25, 0.250, 0.5]}])")),
              ElementsAre("shifted:by=0.5", "shifted:by=0.25"));
  EXPECT_THAT(texts(load(R"(["shifted:times=2.0", "shifted:times=2", "shifted:times=3"])")),
              ElementsAre("shifted:times=2.0", "shifted:times=3"));
}

TEST(UnitStudy, SlugsAreSafeInFileNames) {
  const Study study = load(R"(["shifted:by=0.5,how=up"])");
  EXPECT_EQ(study.methods[0].slug(), "shifted-by-0.5-how-up");
  static constexpr ParameterSpec text[] = {{.name = "text", .kind = ParameterSpec::Kind::text}};
  const scene::MethodRow row = fake_row("odd", false, make_broken, text);
  const auto slug = [&](const char* value) {
    return MethodCall{&row, Parameters("odd", text, {{"text", value}})}.slug();
  };
  EXPECT_EQ(slug("a/b").find('/'), std::string::npos);
  EXPECT_NE(slug("a/b"), slug("a*b"));
}

TEST(UnitStudy, WrongFilesNameFileKeyAndWhatIsAccepted) {
  EXPECT_THAT(methods_error(R"(["shiftd"])"),
              AllOf(HasSubstr("study.json: methods[0]"), HasSubstr("known: shifted")));
  EXPECT_THAT(methods_error(R"(["truth", {"method": "shifted", "bi": 1}])"),
              AllOf(HasSubstr("methods[1]"), HasSubstr("'bi'"), HasSubstr("known: by")));
  EXPECT_THAT(methods_error(R"([{"method": "shifted", "by": [0.5, 2]}])"),
              AllOf(HasSubstr("by=2"), HasSubstr("0 … 1")));
  EXPECT_THAT(methods_error(R"([{"method": "shifted", "by": null}])"),
              AllOf(HasSubstr("methods[0].by"), HasSubstr("accepted: a number")));
  EXPECT_THAT(methods_error(R"([{"method": "shifted", "by": []}])"),
              HasSubstr("at least one value"));
  EXPECT_THAT(methods_error(R"([{"by": 1}])"), HasSubstr("the key 'method' is missing"));
  EXPECT_THAT(methods_error(R"([5])"), HasSubstr("methods[0]: accepted: \"NAME"));
  EXPECT_THAT(methods_error(R"("shifted")"), HasSubstr("methods: \"shifted\"; accepted: an array"));
  EXPECT_THAT(methods_error(R"([])", R"("repeat": 3)"), HasSubstr("'repeat'; known: repeats"));
  EXPECT_THAT(methods_error(R"([])", R"("repeats": 0)"),
              HasSubstr("repeats: 0; accepted: an integer"));
  EXPECT_THAT(methods_error(R"([])", R"("crops": {"won": [0, 0, 1, 1]})"), HasSubstr("known: one"));
  EXPECT_THAT(methods_error(R"([])", R"("reference_scene": {"won": "two.json"})"),
              HasSubstr("known: one"));
  EXPECT_THAT(methods_error(R"([])", R"("reference_scene": {"one": "none.json"})"),
              HasSubstr("reference_scene.one"));
  EXPECT_THAT(methods_error(R"([])", R"("crops": {"one": [0, 0, 0, 1]})"),
              HasSubstr("crops.one[2]"));
}

/// An empty array has no keys to complain of, and one that is not has numbers for keys.
TEST(UnitStudy, WhatIsByTheNamesOfScenesIsAnObject) {
  for (const char* key : {"crops", "probes", "needs"})
    for (const char* value : {"[]", "[1,2]", "null", "5", "\"one\""})
      EXPECT_THAT(methods_error("[]", fmt::format("\"{}\": {}", key, value)),
                  HasSubstr(fmt::format("study.json: {}: {}; accepted: an object", key, value)));
}

TEST(UnitStudy, ScenesAreCheckedBeforeAnyWork) {
  const StudyFolder folder;
  const auto error = [&](const std::string& scenes) -> std::string {
    write_text(folder / "s.json", R"({"format": "pellucid-study", "version": 1, "scenes": )" +
                                      scenes + R"(, "reference": "truth", "methods": []})");
    try {
      load_study(folder / "s.json", fake_methods());
    } catch (const InputError& wrong) {
      return wrong.what();
    }
    return "no error";
  };
  EXPECT_THAT(error(R"(["one.json", "three.json"])"),
              AllOf(HasSubstr("s.json: scenes[1]"), HasSubstr("three.json")));
  EXPECT_THAT(error(R"(["one.json", "s.json"])"),
              AllOf(HasSubstr("s.json: scenes[1]: "), HasSubstr("accepted: pellucid-scene")));
  write_text(folder / "cut.json", R"({"format": "pell)");
  EXPECT_THAT(error(R"(["cut.json"])"),
              AllOf(HasSubstr("s.json: scenes[0]: "), HasSubstr("cut.json: parse error")));
  EXPECT_THAT(error(R"([])"), HasSubstr("at least one scene"));
  EXPECT_THAT(error(R"(["one.json", "./one.json"])"), HasSubstr("a second scene named 'one'"));
  EXPECT_EQ(error(R"(["one.json"])"), "no error");
}

/// The scenes' pictures are of 24×16 and 13×40 pixels.
TEST(UnitStudy, CropsAndProbesLieWithinTheirScenesPictures) {
  for (const char* crop : {"[0, 0, 24, 16]", "[23, 15, 1, 1]"})
    EXPECT_EQ(methods_error("[]", std::string(R"("crops": {"one": )") + crop + "}"), "no error");
  for (const char* crop : {"[0, 0, 25, 16]", "[20, 12, 4, 5]", "[24, 0, 1, 1]"})
    EXPECT_THAT(methods_error("[]", std::string(R"("crops": {"one": )") + crop + "}"),
                HasSubstr(std::string("study.json: crops.one: ") + crop +
                          " is not within the picture; accepted: [x, y, width, height] within "
                          "24×16 pixels"));
  EXPECT_EQ(methods_error("[]", R"("probes": {"two": [[12, 39]]})"), "no error");
  EXPECT_THAT(methods_error("[]", R"("probes": {"two": [[0, 0], [12, 40]]})"),
              HasSubstr("study.json: probes.two[1]: [12, 40] is outside of the picture; accepted: "
                        "[column, row] within 13×40 pixels"));
}

TEST(UnitStudy, AScenesPathIsLookedForBeforeAnyWork) {
  EXPECT_THAT(methods_error("[]", R"("views": "path")"),
              AllOf(HasSubstr("study.json: views: \"path\": "),
                    HasSubstr("one.json has no camera_path; accepted: one, a number of views")));
}

/// Two different views would be measured against each other.
TEST(UnitStudy, AReferenceSceneIsSeenAsItsScene) {
  const StudyFolder folder;
  const auto error_of = [&](const std::string& own, const std::string& reference,
                            const std::string& more = "") -> std::string {
    const auto scene = [&](const char* name, const std::string& keys) {
      write_text(folder / name, R"({"format": "pellucid-scene", "version": 1, )" + keys +
                                    R"("objects": [{"mesh": "triangle.ply"}]})");
    };
    scene("one.json", own);
    scene("true.json", reference);
    try {
      load_study(folder.study("[]", R"("reference_scene": {"one": "true.json"})" + more),
                 fake_methods());
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  };
  const std::string near = R"("camera": {"eye": [0, 0, 4]}, )";
  const std::string far = R"("camera": {"eye": [0, 0, 9]}, )";
  const std::string black = R"("background": [0, 0, 0], )";
  const std::string listed = R"(, "views": [{"eye": [0, 0, 7]}])";
  EXPECT_EQ(error_of(near, near), "no error");
  EXPECT_EQ(error_of("", ""), "no error");
  EXPECT_THAT(error_of(near, far), AllOf(HasSubstr("study.json: reference_scene: "),
                                         HasSubstr("true.json has another camera than ")));
  EXPECT_THAT(error_of(near, ""), HasSubstr("another camera"));
  EXPECT_EQ(error_of(near, far, listed), "no error");
  EXPECT_THAT(error_of(near, near + black, listed), HasSubstr("another background"));
  const auto path = [](const char* degrees) {
    return std::string(R"("camera_path": {"frames": 2, "orbit": )") + degrees + "}, ";
  };
  write_text(folder / "two.json", R"({"format": "pellucid-scene", "version": 1, )" + path("9") +
                                      R"("objects": [{"mesh": "triangle.ply"}]})");
  const std::string along = R"(, "views": "path")";
  EXPECT_EQ(error_of(near + path("9"), near + path("9"), along), "no error");
  EXPECT_THAT(error_of(near + path("9"), near + path("8"), along),
              HasSubstr("another camera_path"));
}

// Methods and integrators: a study needs one of the two.
TEST(UnitStudy, AKeyThatIsMissingIsNamedUnlessAnotherStandsForIt) {
  const StudyFolder folder;
  const auto error = [&](const std::string& more) -> std::string {
    write_text(folder / "s.json",
               R"({"format": "pellucid-study", "version": 1, "scenes": ["one.json"])" + more + "}");
    try {
      load_study(folder / "s.json", fake_methods());
    } catch (const InputError& wrong) {
      return wrong.what();
    }
    return "no error";
  };
  EXPECT_THAT(error(""), HasSubstr("the key 'reference' is missing"));
  EXPECT_THAT(error(R"(, "reference": "truth")"), HasSubstr("the key 'methods' is missing"));
  EXPECT_EQ(error(R"(, "reference": "truth", "integrators": [])"), "no error");
  EXPECT_EQ(error(R"(, "reference": "truth", "methods": [])"), "no error");
}

TEST(UnitStudy, AnotherFormatIsNamedBeforeItsKeys) {
  const StudyFolder folder;
  try {
    load_study(folder / "one.json", fake_methods());
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("accepted: pellucid-study"));
  }
}

TEST(UnitStudy, OtherFormatsAndVersionsAreRefused) {
  const StudyFolder folder;
  EXPECT_THROW(load_study(folder / "one.json", fake_methods()), InputError);
  EXPECT_THROW(load_study(folder / "none.json", fake_methods()), InputError);
  write_text(folder / "cut.json", R"({"format": "pellucid-study", "ver)");
  EXPECT_THROW(load_study(folder / "cut.json", fake_methods()), InputError);
  write_text(folder / "v2.json", R"({"format": "pellucid-study", "version": 2})");
  EXPECT_THROW(load_study(folder / "v2.json", fake_methods()), InputError);
}

TEST(UnitStudy, IntegratorsAreOfTheirOwnTableAndComeFirst) {
  const Study study = load(R"(["shifted"])", R"("integrators": ["fixed-front:rows=5",
      {"integrator": "hultquist", "threshold": [0.1, 0.2]}])");
  EXPECT_THAT(texts(study), ElementsAre("fixed-front:rows=5", "hultquist:threshold=0.1",
                                        "hultquist:threshold=0.2", "shifted"));
  EXPECT_THAT(
      methods_error(R"([])", R"("integrators": ["shifted"])"),
      AllOf(HasSubstr("integrators[0]: unknown integrator 'shifted'"), HasSubstr("hultquist")));
  EXPECT_THAT(methods_error(R"(["hultquist"])"), HasSubstr("unknown method 'hultquist'"));
  EXPECT_THAT(methods_error(R"([])", R"("integrators": [{"method": "hultquist"}])"),
              HasSubstr("the key 'integrator' is missing"));
}

TEST(UnitStudyList, ANameIsFoundAmongTheStudiesThatComeAlong) {
  EXPECT_EQ(find_study("quickstart").filename(), "quickstart.json");
  try {
    find_study("quikstart");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("unknown study 'quikstart'; known: quickstart"));
  }
}

TEST(PropertyStudyList, EveryStudyThatComesAlongIsValid) {
  ASSERT_FALSE(list_studies().empty());
  for (const StudySummary& summary : list_studies()) {
    const Study study = load_study(summary.file, methods());
    EXPECT_EQ(study.title, summary.title);
    EXPECT_FALSE(summary.title.empty()) << summary.name;
  }
}

}  // namespace
}  // namespace pellucid::compare
