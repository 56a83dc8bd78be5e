// SPDX-License-Identifier: GPL-3.0-or-later
// The GL layer: contexts, shader text, errors.
#include <gmock/gmock.h>

#include "core/error.h"
#include "core/machine/stopwatch.h"
#include "oit/gl/driver_check.h"
#include "oit/gl/gl_clock.h"
#include "oit/gl/program.h"
#include "tests/oit/oit_pictures.h"

namespace pellucid::oit {
namespace {

using namespace testing;

using ::testing::ContainsRegex;
using ::testing::HasSubstr;

template <class Call>
std::string message_of(Call&& call) {
  try {
    call();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
}

TEST(UnitContext, SaysWhatItsDriverIs) {
  const GlContext context("osmesa");
  EXPECT_THAT(context.driver(), ContainsRegex("OpenGL 4\\.[56]"));
  EXPECT_NO_THROW(check_driver(context));
}

TEST(UnitContext, AnUnknownKindNamesTheKnownOnes) {
  EXPECT_THROW(GlContext("glx"), InputError);
  EXPECT_THAT(message_of([] { GlContext("glx"); }), HasSubstr("osmesa|egl"));
}

TEST(UnitContext, ReportsErrorsInTheDriversWords) {
  const GlContext context("osmesa");
  context.gl().Enable(GL_INVALID_ENUM);
  const std::string message = message_of([&] { context.check("testing"); });
  EXPECT_THAT(message, HasSubstr("0x0500 while testing"));
  EXPECT_THAT(message, HasSubstr("glEnable"));
  EXPECT_NO_THROW(context.check("testing again"));
}

// A megapixel of floats takes llvmpipe some tenths of a millisecond, and not as long as the wall
// clock says, which is asked outside.
TEST(UnitGlClock, TakesTheTimeOfWhatIsBetween) {
  const GlContext context("osmesa");
  const GlClock clock(context.gl());
  const Texture texture(context.gl(), GL_RGBA32F, 1024, 1024);
  const Framebuffer target(context.gl(), {{texture}});
  for (int again = 0; again < 2; ++again) {
    const Stopwatch watch;
    clock.start();
    target.clear_all(0.5f);
    clock.stop();
    const std::optional<double> seconds = clock.seconds();
    ASSERT_TRUE(seconds.has_value());
    EXPECT_GT(*seconds, 1e-6);
    EXPECT_LT(*seconds, watch.seconds());
  }
}

TEST(UnitContext, AShaderThatDoesNotCompileShowsTheLog) {
  const GlContext context("osmesa");
  const std::string message =
      message_of([&] { Program(context, "void main() {}", {"void main() { x = 1; }"}, {}); });
  EXPECT_THAT(message, HasSubstr("does not compile"));
  EXPECT_THAT(message, HasSubstr("undeclared"));
}

TEST(UnitContext, IncludesAreExpanded) {
  EXPECT_THAT(expand_includes("#include \"oit/optical_depth/optical_depth.glsl\"\nend\n"),
              HasSubstr("float optical_depth(float alpha)"));
  EXPECT_THROW(expand_includes("#include \"oit/nothing.glsl\"\n"), WorkError);
}

TEST(UnitContext, APictureTooLargeIsRefusedBeforeItIsAllocated) {
  const scene::Scene scene = stack(1 << 20, 1, {{1, 1, 1, 1}});
  EXPECT_THROW(render(method("weighted-average"), scene), InputError);
}

// Renderers whose contexts take turns on one thread keep to their own objects.
TEST(UnitContext, RenderersDoNotDisturbEachOther) {
  const std::vector<Rgba> red = {{1, 0, 0, 0.5f}}, green = {{0, 1, 0, 0.5f}};
  const scene::Scene first = stack(3, 3, red), second = stack(2, 2, green);
  const scene::MethodRow& row = method("linked-list");
  const auto a = row.make(first, {}, {});
  {
    const auto b = row.make(second, {}, {});
    // One layer: four roundings of 6e-8.
    EXPECT_LE(largest_difference(b->render({}).image, composite(green, second.background)), 2.4e-7);
    EXPECT_LE(largest_difference(a->render({}).image, composite(red, first.background)), 2.4e-7);
  }
  // The same.
  EXPECT_LE(largest_difference(a->render({}).image, composite(red, first.background)), 2.4e-7);
}

// Where EGL has a driver its pictures are those of OSMesa, up to another order of sums.
TEST(AgreementContext, EglDrawsWhatOsmesaDraws) {
  const scene::Scene scene = stack(9, 5, random_layers(8, 0.9f, 12));
  for (const scene::MethodRow& row : oit_methods()) {
    const Parameters parameters(row.name, row.parameters, {});
    const Image expected = row.make(scene, parameters, {.gl = "osmesa"})->render({}).image;
    Image image;
    try {
      image = row.make(scene, parameters, {.gl = "egl:software"})->render({}).image;
    } catch (const WorkError& error) {
      GTEST_SKIP() << error.what();
    }
    // Two drivers, which may snap, interpolate and round otherwise; not derived, and skipped where
    // there is no second one.
    EXPECT_LE(largest_difference(image, expected), 1e-4) << row.name;
  }
}

}  // namespace
}  // namespace pellucid::oit
