// SPDX-License-Identifier: GPL-3.0-or-later
// The suite's answers are right; what a renderer or its pictures are judged by.
#include "compare/conform/conform.h"

#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "compare/methods/methods.h"
#include "compare/pictures/image_file.h"
#include "core/error.h"
#include "core/files/json_text.h"
#include "core/options/names.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::compare {
namespace {

using pellucid::testing::TemporaryFolder;
using ::testing::HasSubstr;

MethodCall call(std::string_view method) {
  const scene::MethodRow& row = find_row("method", method, methods());
  return {&row, Parameters(row.name, row.parameters, {})};
}

/// The closed forms and the exact renderer come to the same by different ways.
TEST(AgreementConform, RaytracePassesEveryCase) {
  const std::vector<CaseResult> results = conform({.call = call("raytrace")});
  EXPECT_GE(results.size(), 35u);
  for (const CaseResult& result : results) {
    EXPECT_TRUE(result.verdict.passed) << result.name << ": " << result.verdict.explanation;
    EXPECT_LT(result.verdict.max_error, 1e-6) << result.name;  // it is stored in floats
  }
}

/// Which mixes all layers: it is right where a pixel's layers have one colour, and only there.
TEST(AgreementConform, WeightedAverageFailsWhereLayersDiffer) {
  const std::vector<ConformanceCase> cases = conformance_cases();
  for (const CaseResult& result :
       conform({.call = call("weighted-average"), .only = "[!ls]*"})) {  // thin things may miss
    const ConformanceCase& c = *std::ranges::find(cases, result.name, &ConformanceCase::name);
    const bool of_one_color = std::ranges::all_of(c.layers, [](const Layers& layers) {
      return std::ranges::all_of(layers, [&](const Rgba& layer) {
        return layer.a == 0 || Vec3(layer) == Vec3(layers.front()) || layers.front().a == 0;
      });
    });
    if (of_one_color && c.family == "edges") {
      EXPECT_TRUE(result.verdict.passed) << result.name;
    }
    if (!of_one_color && c.family != "opaque" && c.family != "opacity") {
      EXPECT_EQ(result.verdict.fault, Fault::misordered)
          << result.name << ": " << result.verdict.explanation;
    }
  }
}

/// Every family begins with a case of fewer layers, and ends with one that is harder.
TEST(UnitConformanceCases, HaveNamesOfTheirOwnAndPixelsAwayFromRims) {
  std::set<std::string> names;
  for (const ConformanceCase& c : conformance_cases()) {
    EXPECT_TRUE(names.insert(c.name).second) << c.name;
    EXPECT_TRUE(c.name.starts_with(c.family + "-"));
    EXPECT_EQ(c.which.pixels.size(), 256u);
    for (const scene::SceneObject& object : c.scene.objects)
      for (const Vec3& x : object.vertices().positions)
        EXPECT_EQ(x, Vec3(glm::vec3(x))) << c.name << ": its file holds floats";
  }
}

TEST(UnitConformanceCases, CompositeIsTheKnownPower) {
  const Layers equal(10, Rgba(1, 0.5, 0, 0.25));
  const glm::dvec4 sum = composite_of(equal, {0, 0, 1});
  EXPECT_NEAR(sum.a, 1 - std::pow(0.75, 10), 1e-15);
  EXPECT_NEAR(sum.g, 0.5 * sum.a, 1e-15);
  EXPECT_NEAR(sum.b, 1 - sum.a, 1e-15);
}

TEST(UnitConform, TakesPicturesFromAFolderAndTellsWhichAreMissing) {
  const TemporaryFolder folder;
  for (const ConformanceCase& c : conformance_cases())
    if (c.name == "layers-1") write_image(folder / "layers-1.png", expected_picture(c), {});
  const auto results = conform({.call = {}, .pictures = folder.path(), .only = "layers-1*"});
  ASSERT_EQ(results.size(), 5u);
  EXPECT_TRUE(results[0].verdict.passed);
  EXPECT_EQ(results[1].verdict.fault, Fault::no_picture);
  EXPECT_THAT(results[1].verdict.explanation, HasSubstr("neither layers-10.exr nor .png"));
  const auto families = summarize(results);
  ASSERT_EQ(families.size(), 1u);
  EXPECT_EQ(families[0].passed, 1);
  EXPECT_EQ(families[0].first_failed->name, "layers-10");
  EXPECT_THROW(conform({.call = call("raytrace"), .only = "nothing*"}), InputError);
}

TEST(UnitConform, LeavesItsScenesForOthers) {
  const TemporaryFolder folder;
  make_conformance_scenes(folder.path(), "opaque-*");
  const nlohmann::json list = read_json(folder / "cases.json");
  ASSERT_EQ(list["cases"].size(), 2u);
  EXPECT_EQ(read_json(folder / "opaque-object" / "scene.json")["objects"][1]["opaque"], true);
  EXPECT_EQ(read_image(folder / "opaque-alpha" / "expected.exr").width, 16);
}

}  // namespace
}  // namespace pellucid::compare
