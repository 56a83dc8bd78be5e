// SPDX-License-Identifier: GPL-3.0-or-later
// Studies whose scenes are seen from several cameras.
#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "compare/cells/view_rows.h"
#include "compare/pictures/image_file.h"
#include "compare/results/measure_columns.h"
#include "core/error.h"
#include "tests/compare/run/studies.h"
#include "tests/compare/study_error.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using namespace pellucid::compare::testing;

/// A picture of one grey that depends on where the camera stands, a tenth of its x, and is wrong by
/// some function of it.
class SeeingRenderer final : public scene::Renderer {
 public:
  SeeingRenderer(const scene::Scene& scene, double error)
      : image_(scene.width, scene.height, Rgba(float(0.1 * scene.camera.eye.x + error))) {}

  scene::Rendering render(const scene::RenderRequest&) override {
    scene::Rendering rendering;
    rendering.image = image_;
    rendering.stats.steps = {{"all", 0.5 + std::abs(image_.pixels[0].r)}};
    rendering.stats.fragments = std::uint64_t(std::lround(100 * std::abs(image_.pixels[0].r)));
    return rendering;
  }
  std::vector<std::string> explain() const override { return {}; }

 private:
  Image image_;
};

using ErrorAt = double (*)(double x);

double none(double) { return 0; }
double steady(double) { return 0.25; }
double alternating(double x) { return std::lround(x) % 2 == 0 ? 0.125 : -0.125; }
double growing(double x) {
  if (x > 8) throw WorkError("it sees nothing");
  return 0.1 * x;
}

template <ErrorAt error>
Made make_seeing(const scene::Scene& scene, const Parameters&, const scene::RenderContext&) {
  return std::make_unique<SeeingRenderer>(scene, error(scene.camera.eye.x));
}

std::span<const scene::MethodRow> seeing_methods() {
  static const scene::MethodRow rows[] = {fake_row("truth", true, make_seeing<none>),
                                          fake_row("same", false, make_seeing<none>),
                                          fake_row("steady", false, make_seeing<steady>),
                                          fake_row("alternating", false, make_seeing<alternating>),
                                          fake_row("growing", false, make_seeing<growing>)};
  return rows;
}

constexpr const char* three_views =
    R"("repeats": 1, "views": [{"eye": [1, 0, 5]}, {"eye": [2, 0, 5]}, {"eye": [3, 0, 5]}])";

StudyOutcome see(const StudyFolder& folder, const std::string& more, bool resume = false) {
  StudyOptions options;
  options.folder = folder / "results";
  options.resume = resume;
  return run_study(
      load_study(folder.study(R"(["steady", "alternating", "growing"])", more), seeing_methods()),
      options);
}

void add_path(const fs::path& scene, const std::string& path) {
  std::string text = read_text(scene);
  text.insert(text.rfind('}'), ", \"camera\": {\"eye\": [1, 0, 5]}, \"camera_path\": " + path);
  write_text(scene, text);
}

constexpr double float_grey = 1e-7;  // pictures hold floats below 1

TEST(UnitViews, ARowIsTheMeanAndTheWorstStandsBeside) {
  const StudyFolder folder;
  const StudyOutcome outcome = see(folder, three_views);
  const ResultRow& growing = row_of(outcome, "one", "growing");
  EXPECT_EQ(growing.error, "");
  EXPECT_NEAR(*growing.metrics.linear.of("rmse"), 0.2, float_grey);
  EXPECT_NEAR(*measure_of(growing, "rmse_worst"), 0.3, float_grey);
  EXPECT_LT(*measure_of(growing, "ssim_worst"), *growing.metrics.linear.of("ssim"));
  EXPECT_EQ(measure_of(growing, "views"), 3);
  EXPECT_NEAR(growing.seconds.median, 0.5 + 0.4, float_grey);  // of 0.7, 0.9 and 1.1
  EXPECT_NEAR(growing.seconds.max, 1.1, float_grey);
  EXPECT_EQ(growing.fragments, 40u);
  EXPECT_NEAR(*row_of(outcome, "one", "steady").metrics.linear.of("rmse"), 0.25, float_grey);
}

TEST(UnitViews, TheWorstOfEqualPicturesIsInfinitelyGood) {
  const StudyFolder folder;
  StudyOptions options;
  options.folder = folder / "results";
  const StudyOutcome outcome =
      run_study(load_study(folder.study(R"(["same"])", three_views), seeing_methods()), options);
  const ResultRow& same = row_of(outcome, "one", "same");
  EXPECT_EQ(measure_of(same, "rmse_worst"), 0);
  EXPECT_EQ(measure_of(same, "psnr_worst"), std::numeric_limits<double>::infinity());
}

/// One view is equal, and in one alone something is lost: means tell of both.
TEST(UnitViews, AMeanHidesNeitherErrorsNorLosses) {
  const StudyFolder folder;
  const auto seen = [&](const ResultRow& row, double error) {
    ResultRow view = row;
    view.metrics.linear.of("psnr") = error > 0 ? 20 : std::numeric_limits<double>::infinity();
    view.dropped = error > 0 ? 1 : 0;
    view.given = "command";
    view.given_faults = error > 0 ? std::vector<std::string>{"always", "upside down"}
                                  : std::vector<std::string>{"always"};
    if (error > 0) view.bytes = {{"all", 7}};
    return view;
  };
  const ResultRow one = row_of(see(folder, three_views), "one", "steady");
  const Image picture(2, 2, Rgba(0));
  ViewRows rows(false);
  for (const double error : {0., 0.1, 0., 0.}) rows.add(seen(one, error), picture, picture);
  const ResultRow mean = rows.row();
  EXPECT_EQ(*mean.metrics.linear.of("psnr"), 20);
  EXPECT_EQ(mean.dropped, 1u);
  EXPECT_THAT(mean.given_faults, ElementsAre("always", "from view 2 upside down"));
  EXPECT_TRUE(mean.bytes.empty());  // of three views they are not known
  EXPECT_TRUE(to_json(mean)["bytes"]["total"].is_null());
}

TEST(UnitViews, TheErrorOverTheViewsIsACurve) {
  const StudyFolder folder;
  const ResultRow row = row_of(see(folder, three_views), "one", "growing");
  const auto curve = std::ranges::find(row.curves, "RMSE over the views", &RowCurve::name);
  ASSERT_NE(curve, row.curves.end());
  EXPECT_THAT(curve->x, ElementsAre(1, 2, 3));
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(curve->y[i], 0.1 * double(i + 1), float_grey);
}

TEST(UnitViews, OtherCurvesAreOfTheFirstViewAndSaySo) {
  const StudyFolder folder;
  const auto title = [&](const std::string& views) {
    const ResultRow row =
        row_of(see(folder, views + R"(, "measures": ["depth-error"])"), "one", "steady");
    return std::ranges::find(row.curves, "depth error", &RowCurve::name)->title;
  };
  EXPECT_EQ(title(three_views), "Error over the depth of the nearest layer, view 1");
  EXPECT_EQ(title(R"("repeats": 1)"), "Error over the depth of the nearest layer");
}

TEST(UnitViews, EachViewHasItsPictures) {
  const StudyFolder folder;
  see(folder, three_views);
  const fs::path images = folder / "results/images/one";
  EXPECT_NEAR(read_image(images / "truth.exr").at(0, 0).r, 0.1, float_grey);
  EXPECT_NEAR(read_image(images / "truth.view-3.exr").at(0, 0).r, 0.3, float_grey);
  for (const char* file : {"growing.view-2.png", "growing.view-2.error.png", "growing.view-3.exr"})
    EXPECT_TRUE(fs::exists(images / file)) << file;
}

// A constant error is none of time; one of alternating sign changes by twice itself.
TEST(UnitViews, FlickerIsWhatTheErrorChangesAlongAPath) {
  const StudyFolder folder;
  for (const char* scene : {"one.json", "two.json"})
    add_path(folder / scene, R"({"frames": 4, "keys": [{"eye": [1, 0, 5]}, {"eye": [4, 0, 5]}]})");
  const StudyOutcome outcome = see(folder, R"("repeats": 1, "views": "path")");
  EXPECT_NEAR(*measure_of(row_of(outcome, "one", "steady"), "flicker"), 0, float_grey);
  EXPECT_NEAR(*measure_of(row_of(outcome, "one", "alternating"), "flicker"), 0.25, float_grey);
  EXPECT_NEAR(*measure_of(row_of(outcome, "one", "growing"), "flicker"), 0.1, float_grey);
  EXPECT_EQ(*measure_of(row_of(outcome, "one", "truth"), "flicker"), 0);
  EXPECT_EQ(measure_of(row_of(outcome, "one", "truth"), "views"), 4);
}

TEST(UnitViews, OfViewsThatAreNoPathThereIsNoFlicker) {
  const StudyFolder folder;
  EXPECT_FALSE(measure_of(row_of(see(folder, three_views), "one", "alternating"), "flicker"));
}

// Four views at right angles: the camera's own, a quarter around, opposite, and back.
TEST(UnitViews, AnOrbitGoesAroundTheTarget) {
  const StudyFolder folder;
  for (const char* scene : {"one.json", "two.json"})
    add_path(folder / scene, R"({"frames": 2, "orbit": 1})");
  see(folder, R"("repeats": 1, "views": 4)");
  const fs::path images = folder / "results/images/one";
  // About +y from (1, 0, 5): x is 1, 5, -1, -5.
  for (const auto& [file, x] : {std::pair("truth.exr", 1.),
                                {"truth.view-2.exr", 5.},
                                {"truth.view-3.exr", -1.},
                                {"truth.view-4.exr", -5.}})
    EXPECT_NEAR(read_image(images / file).at(0, 0).r, 0.1 * x, float_grey) << file;
}

TEST(UnitViews, AViewThatFailsIsNamed) {
  const StudyFolder folder;
  const StudyOutcome outcome =
      see(folder, R"("repeats": 1, "views": [{"eye": [1, 0, 5]}, {"eye": [9, 0, 5]}])");
  EXPECT_EQ(row_of(outcome, "one", "growing").error, "view 2: it sees nothing");
  EXPECT_EQ(row_of(outcome, "one", "steady").error, "");
}

TEST(UnitViews, ResumingKeepsACellWhoseViewsAreAllThere) {
  const StudyFolder folder;
  see(folder, three_views);
  EXPECT_EQ(see(folder, three_views, true).computed, 0u);
  fs::remove(folder / "results/images/one/steady.view-2.exr");
  EXPECT_EQ(see(folder, three_views, true).computed, 1u);
  EXPECT_EQ(see(folder, R"("repeats": 1, "views": [{"eye": [1, 0, 5]}])", true).computed, 8u);
}

TEST(UnitViews, TimingIsOfEachView) {
  const StudyFolder folder;
  const StudyOutcome outcome =
      see(folder, R"("timing": {"max": 6}, "views": [{"eye": [1, 0, 5]}, {"eye": [2, 0, 5]}])");
  const ResultRow& row = row_of(outcome, "one", "steady");
  EXPECT_EQ(row.repeats, 5);
  EXPECT_EQ(row.settled, true);
  EXPECT_NEAR(row.seconds.interval->low, 0.5 + 0.25 + 0.15, float_grey);
}

std::string views_error(const std::string& views) {
  return study_error("[]", R"("views": )" + views);
}

TEST(UnitViews, WhatIsNoViewIsRefused) {
  EXPECT_THAT(views_error("1"), HasSubstr("views: 1; accepted: an integer, 2"));
  EXPECT_THAT(views_error(R"("way")"),
              HasSubstr("views: accepted: a number of views on an orbit, \"path\""));
  EXPECT_THAT(views_error("[]"), HasSubstr("0 cameras; accepted: 1 to 1000"));
  EXPECT_THAT(views_error("true"), HasSubstr("views: accepted: a number of views"));
  EXPECT_THAT(views_error(R"([{"eye": [0, 0, 1], "tarjet": [0, 0, 0]}])"),
              HasSubstr("views[0]: unknown key 'tarjet'"));
  EXPECT_THAT(views_error(R"([{"eye": [0, 0, 1], "target": [0, 0, 1]}])"), HasSubstr("views[0]: "));
}

}  // namespace
}  // namespace pellucid::compare
