// SPDX-License-Identifier: GPL-3.0-or-later
// Methods that a file describes: the examples against the methods that they are, and what is
// refused.
#include "oit/methods/written/glsl_method.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "core/files/output_file.h"
#include "tests/oit/oit_pictures.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::oit {
namespace {

using namespace testing;
using ::testing::AllOf;
using ::testing::HasSubstr;

const std::string examples = PELLUCID_SOURCE_DIR "/examples/glsl/";

scene::Scene layers_of_all_sizes(int n) {
  scene::Scene scene = stack(7, 5, random_layers(n, 0.7f, unsigned(n)));
  return scene;
}

/// Both sum in float; `weight` of the example takes pow(), of which llvmpipe keeps some 20 bits.
TEST(AgreementGlslMethod, ExamplesAreTheMethodsThatTheyAre) {
  for (const int n : {1, 3, 12, 60}) {
    const scene::Scene scene = layers_of_all_sizes(n);
    EXPECT_LE(
        largest_difference(
            render(glsl_method(), scene, {{"file", examples + "weighted-blended.json"}}).image,
            render(method("weighted-blended"), scene, {{"weight", "7"}}).image),
        1e-5)
        << n;
    for (const char* bins : {"1", "5", "64"})
      EXPECT_LE(largest_difference(render(glsl_method(), scene,
                                          {{"file", examples + "bin-average.json"},
                                           {"parameters", std::string("bins=") + bins}})
                                       .image,
                                   render(method("bin-average"), scene, {{"bins", bins}}).image),
                float_composite)
          << n << ' ' << bins;
  }
}

TEST(UnitGlslMethod, IsCountedAndTimedAsAnyMethod) {
  const scene::Scene scene = layers_of_all_sizes(9);
  const scene::Rendering rendering =
      render(glsl_method(), scene, {{"file", examples + "weighted-blended.json"}}, true);
  EXPECT_EQ(rendering.stats.total_bytes(), 20u * 7 * 5);
  EXPECT_EQ(rendering.stats.fragments, 9u * 7 * 5);
  std::vector<std::string> steps;
  for (const scene::StepTime& step : rendering.stats.steps) steps.push_back(step.name);
  EXPECT_THAT(steps, ::testing::ElementsAre("clear", "accumulate", "composite"));
}

/// Files that are wrong in one thing.
class UnitGlslFile : public ::testing::Test {
 protected:
  std::string refusal(const std::string& json, const std::string& parameters = {}) {
    write_text(folder_ / "draw.glsl", draw_);
    write_text(folder_ / "show.glsl",
               "void main() {\n  picture = texelFetch(sum, ivec2(0), 0);\n}\n");
    write_text(folder_ / "m.json", json);
    RawOptions options{{"file", (folder_ / "m.json").string()}};
    if (!parameters.empty()) options.emplace("parameters", parameters);
    try {
      render(glsl_method(), layers_of_all_sizes(2), options);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  }
  /// A method that is right, with one text in the place of another.
  std::string with(const std::string& old, const std::string& text) {
    std::string json = whole;
    json.replace(json.find(old), old.size(), text);
    return refusal(json);
  }

  const std::string whole =
      R"({"format": "pellucid-glsl-method", "version": 1,
          "parameters": {"k": {"default": 0.5, "min": 0, "max": 1}},
          "textures": {"sum": {"format": "rgba32f"}, "ids": {"format": "r32ui"}},
          "passes": [{"geometry": "draw.glsl", "into": {"sum": "add"}},
                     {"screen": "show.glsl", "reads": ["sum"]}]})";
  std::string draw_ = "void main() {\n  sum = vec4(k * fragment().alpha);\n}\n";
  pellucid::testing::TemporaryFolder folder_;
};

TEST_F(UnitGlslFile, WhatIsRightIsAccepted) {
  EXPECT_EQ(refusal(whole), "accepted");
  EXPECT_EQ(refusal(whole, "k=1"), "accepted");
}

TEST_F(UnitGlslFile, ParametersAreCheckedAsAllAre) {
  EXPECT_THAT(refusal(whole, "k=2"), AllOf(HasSubstr("k=2"), HasSubstr("accepted: 0 … 1")));
  EXPECT_THAT(refusal(whole, "j=1"), HasSubstr("unknown key 'j'; known: k"));
  EXPECT_THAT(refusal(whole, "k"), HasSubstr("accepted: NAME=VALUE"));
  EXPECT_THAT(refusal(whole, "k=1 k=0"), HasSubstr("'k' is given twice"));
}

TEST_F(UnitGlslFile, CompilersWordsCarryTheFilesLines) {
  draw_ =
      "#include \"oit/optical_depth/optical_depth.glsl\"\n\nvoid main() {\n  sum = vec5(1);\n}\n";
  EXPECT_THAT(refusal(whole), AllOf(HasSubstr("draw.glsl"), HasSubstr(":4("), HasSubstr("vec5")));
  draw_ = "#include \"oit/nothing.glsl\"\nvoid main() {}\n";
  EXPECT_THAT(refusal(whole), AllOf(HasSubstr("draw.glsl"), HasSubstr("oit/nothing.glsl")));
}

/// Of names that GLSL reserves, and that the program has, no shader of the file's is to blame.
TEST_F(UnitGlslFile, TakenNamesAreErrorsOfTheFile) {
  EXPECT_THAT(
      with("\"k\":", "\"float\":"),
      AllOf(HasSubstr("m.json: parameters.float: the name 'float'"), Not(HasSubstr("draw.glsl"))));
  draw_ = "void main() {\n  sum = vec4(fragment().alpha);\n}\n";
  EXPECT_THAT(with("\"k\":", "\"picture\":"),
              HasSubstr("m.json: parameters.picture: the name 'picture'"));
}

TEST_F(UnitGlslFile, WhatCannotBeDrawnIsRefusedWithItsPlace) {
  EXPECT_THAT(with("\"rgba32f\"", "\"rgba32\""), HasSubstr("textures.sum.format: unknown format"));
  EXPECT_THAT(with("\"add\"", "\"addd\""), HasSubstr("passes[0].into.sum: unknown blend"));
  EXPECT_THAT(with("{\"sum\": \"add\"}", "{\"ids\": \"add\"}"), HasSubstr("accepted: replace"));
  EXPECT_THAT(with("\"reads\": [\"sum\"]", "\"reads\": [\"som\"]"),
              HasSubstr("unknown texture 'som'"));
  EXPECT_THAT(with("\"reads\": [\"sum\"]", "\"reads\": [\"sum\", \"sum\"]"),
              HasSubstr("used twice"));
  EXPECT_THAT(with("\"screen\": \"show.glsl\", ",
                   "\"screen\": \"show.glsl\", \"into\": {\"ids\": \"replace\"}, "),
              HasSubstr("passes: the last one has to draw the picture"));
  EXPECT_THAT(with(", \"into\": {\"sum\": \"add\"}", ""), HasSubstr("leaves nothing behind"));
  EXPECT_THAT(with("\"k\":", "\"k k\":"), HasSubstr("the name 'k k'"));
  EXPECT_THAT(with("\"k\":", "\"sum\":"), HasSubstr("a parameter has this name"));
  EXPECT_THAT(with("\"draw.glsl\"", "\"drew.glsl\""), HasSubstr("m.json: passes[0].geometry: "));
  EXPECT_THAT(with("\"r32ui\"", "\"r32ui\", \"layers\": \"k\""),
              HasSubstr("accepted: one that is whole"));
}

}  // namespace
}  // namespace pellucid::oit
