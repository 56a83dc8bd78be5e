// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "compare/pictures/image_file.h"
#include "compare/results/columns.h"
#include "core/error.h"
#include "tests/compare/run/studies.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using namespace pellucid::compare::testing;

TEST(UnitRunStudy, ARowSaysWhatTheRendererDid) {
  const StudyFolder folder;
  const StudyOutcome outcome = run(folder, two_methods);
  EXPECT_EQ(outcome.computed, 6u);
  const ResultRow& row = row_of(outcome, "one", "shifted");
  EXPECT_EQ(row.parameters, "by=0.5");
  EXPECT_EQ(row.parameter_values.at("how"), "up");
  EXPECT_DOUBLE_EQ(*row.metrics.linear.of("rmse"), 0.5);
  EXPECT_EQ(row.metrics.linear.of("max_error"), 0.5);
  EXPECT_EQ(row.seconds.median, 0.75);
  ASSERT_EQ(row.steps.size(), 2u);
  EXPECT_EQ(row.steps[1].first, "second");
  EXPECT_EQ(row.steps[1].second.max, 0.5);
  EXPECT_EQ(row.total_bytes(), 1024u);
  EXPECT_EQ(row.fragments, 3u * 24 * 16);
  EXPECT_EQ(row.max_layers, 3u);
  EXPECT_EQ(row.machine.at("driver"), "none");
  EXPECT_FALSE(row.coverage.has_value());
  EXPECT_EQ(row_of(outcome, "two", "truth").metrics.linear.of("rmse"), 0);
}

TEST(UnitRunStudy, OneWarmUpAndAllRepeats) {
  const StudyFolder folder;
  RenderCounter::renders = 0;
  run(folder, "[]");
  EXPECT_EQ(RenderCounter::renders, 2 * (1 + 2));  // two scenes
}

TEST(UnitRunStudy, ARayTracerThatIsTimedOnceIsDrawnOnce) {
  scene::MethodRow tracer = fake_methods().front();
  tracer.promises.in_double = true;
  const std::span<const scene::MethodRow> only(&tracer, 1);
  const StudyFolder folder;
  StudyOptions options;
  options.folder = folder / "results";
  for (const auto& [repeats, renders] : {std::pair(1, 1), {2, 1 + 2}}) {
    RenderCounter::renders = 0;
    const std::string more = R"("repeats": )" + std::to_string(repeats);
    const StudyOutcome outcome = run_study(load_study(folder.study("[]", more), only), options);
    EXPECT_EQ(RenderCounter::renders, 2 * renders);  // two scenes
    const ResultRow& row = row_of(outcome, "one", "truth");
    EXPECT_EQ(row.repeats, repeats);
    EXPECT_EQ(row.seconds.median, 0.75);
    EXPECT_EQ(row.max_layers, 3u);
  }
}

TEST(UnitRunStudy, ExactMethodsAreAlsoComparedWhereLayersAgree) {
  const StudyFolder folder;
  const StudyOutcome outcome = run(folder, two_methods);
  const CoverageCheck check = row_of(outcome, "one", "exact-shifted").coverage.value();
  EXPECT_EQ(check.differing, 1u);
  EXPECT_EQ(check.pixels, 24u * 16);
  EXPECT_DOUBLE_EQ(check.rmse_elsewhere.value(), 0.125);
}

// Every pixel of the fakes has three layers, but for the ones that a test's method adds.
TEST(UnitRunStudy, LayersTellThePixelsApart) {
  const StudyFolder folder;
  const StudyOutcome outcome = run(folder, R"(["shifted:by=0.75", "exact-shifted"])");
  const ResultRow& row = row_of(outcome, "one", "shifted");
  const Metrics& m = row.metrics.linear;
  EXPECT_EQ(m.covered, 1);
  EXPECT_EQ(m.of("rmse_covered"), m.of("rmse"));
  EXPECT_DOUBLE_EQ(*m.of("rmse_equal"), 0.75);
  EXPECT_NE(m.of("flip_equal"), m.of("flip"));  // two pixels of 384 have more
  ASSERT_EQ(row.curves.size(), 1u);
  EXPECT_EQ(row.curves[0].x, std::vector<double>{3});
  EXPECT_DOUBLE_EQ(row.curves[0].y.at(0), 0.75);
  EXPECT_TRUE(row_of(outcome, "one", "truth").curves.empty());
  const ResultRow& exact = row_of(outcome, "one", "exact-shifted");
  EXPECT_DOUBLE_EQ(*exact.metrics.linear.of("rmse_equal"), *exact.coverage->rmse_elsewhere);
}

TEST(UnitRunStudy, LayersOfItsOwnAreShownBesideTheReferences) {
  const StudyFolder folder;
  const StudyOutcome outcome = run(folder, R"(["layering", "shifted"])");
  const CoverageCheck check = row_of(outcome, "one", "layering").coverage.value();
  EXPECT_EQ(check.differing, 2u);
  EXPECT_EQ(check.differing_by_more, 1u);
  const fs::path images = folder / "results/images/one";
  EXPECT_TRUE(fs::exists(images / "layering.layers.png"));
  EXPECT_TRUE(fs::exists(images / "truth.layers.png"));
  EXPECT_FALSE(fs::exists(images / "shifted.layers.png"));
  EXPECT_TRUE(fs::exists(images / "layering.layer-difference.png"));
  EXPECT_FALSE(fs::exists(images / "truth.layer-difference.png"));
  EXPECT_NE(read_image(images / "truth.layers.png").at(2, 0),
            read_image(images / "layering.layers.png").at(2, 0));
}

TEST(UnitRunStudy, EveryFileIsThere) {
  const StudyFolder folder;
  run(folder, two_methods);
  const fs::path results = folder / "results";
  for (const char* name : {"results.csv", "results.json", "table.md", "table.tex", "report.html",
                           "images/one/truth.exr", "images/one/truth.layers.exr",
                           "images/two/shifted-by-0.5.png", "images/two/shifted-by-0.5.error.png",
                           "images/two/shifted-by-0.5.flip.png", "cells/two/exact-shifted.json"})
    EXPECT_TRUE(fs::is_regular_file(results / name)) << name;
  EXPECT_THAT(
      read_text(results / "results.csv"),
      StartsWith("scene,method,parameters,rmse,ssim,psnr,seconds,bytes,fragments,max_layers"));
  const auto json = nlohmann::json::parse(read_text(results / "results.json"));
  EXPECT_EQ(json["rows"].size(), 6u);
  EXPECT_EQ(json["rows"][1]["metrics"]["rmse"], 0.5);
  EXPECT_EQ(read_image(results / "images/one/truth.exr").at(3, 5).g, 15 / 128.f);
}

TEST(UnitRunStudy, AFailingCellIsARowAndTheOthersGoOn) {
  const StudyFolder folder;
  const StudyOutcome outcome = run(folder, R"(["broken", "not-a-number", "shifted"])");
  EXPECT_EQ(outcome.rows.size(), 8u);
  EXPECT_THAT(row_of(outcome, "one", "broken").error, HasSubstr("the driver lacks"));
  EXPECT_THAT(row_of(outcome, "one", "not-a-number").error,
              HasSubstr("384 of its picture's pixels"));
  EXPECT_DOUBLE_EQ(*row_of(outcome, "two", "shifted").metrics.linear.of("rmse"), 0.25);
  const std::string csv = read_text(folder / "results/results.csv");
  // Scene, method, no parameters, and none of the numbers.
  const std::string empty(columns().size() + 2, ',');
  EXPECT_THAT(csv, HasSubstr("one,broken" + empty + "\"the driver lacks \"\"everything\"\""));
  EXPECT_THAT(read_text(folder / "results/table.md"), HasSubstr("failed: the driver lacks"));
  EXPECT_THAT(read_text(folder / "results/table.tex"), HasSubstr("failed: the driver lacks"));
}

TEST(UnitRunStudy, WhatOnlySomeMethodsKnowIsInEveryTable) {
  const StudyFolder folder;
  const StudyOutcome outcome = run(folder, R"(["shifted", "measuring", "broken"])");
  EXPECT_TRUE(fs::is_regular_file(folder / "results/images/one/measuring.depth.png"));
  const std::string csv = read_text(folder / "results/results.csv");
  EXPECT_THAT(csv, HasSubstr(",nodes,spread,error\n"));
  EXPECT_THAT(csv, HasSubstr(",12,0.12345678,\n"));
  EXPECT_THAT(csv, HasSubstr(",,,\"the driver"));
  EXPECT_THAT(
      read_text(folder / "results/table.md"),
      HasSubstr("| | measuring |\n|---|---:|\n| Nodes_made | 12 |\n| Spread [m] | 0.1235 |"));
  EXPECT_THAT(read_text(folder / "results/table.tex"),
              HasSubstr("Nodes\\_made & 12 \\\\\nSpread [m] & 0.1235"));
  const ResultRow& row = row_of(outcome, "one", "measuring");
  EXPECT_EQ(to_json(row_from_json(to_json(row))), to_json(row));
  EXPECT_TRUE(row_of(outcome, "one", "shifted").measures.empty());
}

TEST(UnitRunStudy, WithoutAReferenceItsSceneFails) {
  const StudyFolder folder;
  write_text(folder / "two.json",
             R"({"format": "pellucid-scene", "version": 1, "objects": [{"mesh": "none.ply"}]})");
  const StudyOutcome outcome = run(folder, two_methods);
  EXPECT_THAT(row_of(outcome, "two", "truth").error, HasSubstr("none.ply"));
  EXPECT_THAT(row_of(outcome, "two", "shifted").error, HasSubstr("reference"));
  EXPECT_TRUE(row_of(outcome, "one", "shifted").error.empty());
}

TEST(UnitRunStudy, ARowSurvivesItsFile) {
  const StudyFolder folder;
  for (const ResultRow& row : run(folder, R"(["exact-shifted", "broken"])").rows)
    EXPECT_EQ(to_json(row_from_json(to_json(row))), to_json(row));
}

TEST(UnitRunStudy, AFolderThatCannotBeMadeIsNamed) {
  const StudyFolder folder;
  write_text(folder / "results", "in the way");
  EXPECT_THROW(run(folder, "[]"), InputError);
}

TEST(UnitRunStudy, AReferenceMayDrawASceneOfItsOwn) {
  const StudyFolder folder;
  write_scene(folder / "two.json", 24, 16);  // as one.json, so that the pictures compare
  write_scene(folder / "truth.json", 24, 16);
  const auto study = [&] {
    return load_study(folder.study(R"(["shifted"])", R"("reference_scene": "truth.json")"),
                      fake_methods());
  };
  StudyOptions options;
  options.folder = folder / "results";
  for (const ResultRow& row : run_study(study(), options).rows) EXPECT_EQ(row.error, "");
  options.resume = true;
  EXPECT_EQ(run_study(study(), options).computed, 0u);
  // All cells depend on the reference's scene; those of a scene also on theirs.
  write_scene(folder / "two.json", 24, 17);
  EXPECT_EQ(run_study(study(), options).computed, 1u);
  write_scene(folder / "truth.json", 24, 17);
  EXPECT_EQ(run_study(study(), options).computed, 4u);
}

TEST(UnitRunStudy, AReferenceMayDrawAnotherSceneForEach) {
  const StudyFolder folder;
  write_scene(folder / "truth.json", 13, 40);  // of the size of two.json
  const std::string own = R"("repeats": 1, "reference_scene": {"two": "truth.json"})";
  const auto study = [&] {
    return load_study(folder.study(R"(["shifted"])", own), fake_methods());
  };
  const std::vector<Cell> cells = expand_cells(study());
  ASSERT_EQ(cells.size(), 4u);
  EXPECT_EQ(cells[0].scene_file.filename(), "one.json");
  EXPECT_EQ(cells[2].scene_file.filename(), "truth.json");
  EXPECT_EQ(cells[3].scene_file.filename(), "two.json");
  StudyOptions options;
  options.folder = folder / "results";
  for (const ResultRow& row : run_study(study(), options).rows) EXPECT_EQ(row.error, "");
  options.resume = true;
  write_scene(folder / "truth.json", 13, 41);  // the other scene's cells do not depend on it
  EXPECT_EQ(run_study(study(), options).computed, 2u);
}

}  // namespace
}  // namespace pellucid::compare
