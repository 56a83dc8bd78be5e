// SPDX-License-Identifier: GPL-3.0-or-later
// Exact sums in OpenEXR files: closed forms of stacks, and deep samples that composite to the
// picture.

#include "compare/pictures/sums_file.h"

#include <OpenImageIO/deepdata.h>
#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "core/error.h"
#include "groundtruth/methods/raytrace.h"
#include "tests/support/pictures.h"
#include "tests/support/scenes.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::compare {
namespace {

using ::testing::UnorderedElementsAre;
using namespace testing;

Image raytraced(const scene::Scene& scene) {
  return render(groundtruth::raytrace_method(), scene).image;
}

/// A half of the picture is behind eight layers of α = 1/4, the other is empty.
scene::Scene half_a_stack(int samples) {
  scene::Scene scene = orthographic_scene(4, 2);
  scene.samples = samples;
  for (int i = 0; i < 8; ++i)
    scene.objects.push_back(
        {"layer", rectangle(-2.5, 0, -1.5, 1.5, 1 - i * 0.25, Rgba(1, 0.5, 0, 0.25f))});
  for (scene::SceneObject& object : scene.objects) object.vertices().importance.assign(4, 0.5f);
  return scene;
}

TEST(UnitPictureSums, AStackInClosedForm) {
  for (const int samples : {1, 2}) {
    const scene::Scene scene = half_a_stack(samples);
    const Raster<groundtruth::PixelSums> sums =
        groundtruth::picture_sums(scene, groundtruth::RayProbe(scene), {});
    const groundtruth::PixelSums& full = sums.at(0, 1);
    EXPECT_EQ(full.layers, 8);
    EXPECT_EQ(full.coverage, 1);
    EXPECT_EQ(full.transmittance, float(std::pow(0.75, 8)));
    EXPECT_EQ(full.importance_sum, 2);
    EXPECT_FLOAT_EQ(full.optical_depth, float(-8 * std::log(0.75)));
    EXPECT_EQ(full.near, 4);
    EXPECT_EQ(full.far, 5.75);
    const groundtruth::PixelSums& empty = sums.at(3, 0);
    EXPECT_EQ(empty.layers, 0);
    EXPECT_EQ(empty.coverage, 0);
    EXPECT_EQ(empty.transmittance, 1);
    EXPECT_EQ(empty.near, std::numeric_limits<float>::infinity());
  }
}

TEST(UnitPictureSums, APixelIsTheMeanOfItsSamples) {
  // The edge at x = 0 cuts the only column of pixels in half.
  scene::Scene scene = half_a_stack(2);
  scene.width = 1;
  scene.height = 2;
  const groundtruth::PixelSums sums =
      groundtruth::picture_sums(scene, groundtruth::RayProbe(scene), {}).at(0, 0);
  EXPECT_EQ(sums.coverage, 0.5);
  EXPECT_EQ(sums.importance_sum, 1);
  EXPECT_EQ(sums.layers, 8);
}

class UnitSumsFile : public ::testing::Test {
 protected:
  TemporaryFolder folder_;
};

TEST_F(UnitSumsFile, HoldsAChannelForEachSum) {
  const scene::Scene scene = half_a_stack(1);
  const auto path = folder_ / "sums.exr";
  write_sums(path, groundtruth::picture_sums(scene, groundtruth::RayProbe(scene), {}));
  const auto file = OIIO::ImageInput::open(path.string());
  ASSERT_TRUE(file) << OIIO::geterror();
  EXPECT_THAT(file->spec().channelnames,
              UnorderedElementsAre("layers", "coverage", "transmittance", "importance_sum",
                                   "optical_depth", "near", "far"));
  std::vector<float> values(4 * 2 * 7);
  ASSERT_TRUE(file->read_image(0, 0, 0, 7, OIIO::TypeDesc::FLOAT, values.data()));
  const auto& names = file->spec().channelnames;
  const auto channel = [&](const char* name) {
    return std::size_t(std::ranges::find(names, name) - names.begin());
  };
  EXPECT_EQ(values[channel("layers")], 8);
  EXPECT_EQ(values[channel("far")], 5.75);
  EXPECT_EQ(values[7 * 3 + channel("transmittance")], 1);
}

TEST_F(UnitSumsFile, DeepSamplesCompositeToThePicture) {
  scene::Scene scene;
  scene.width = 17;
  scene.height = 9;
  scene.objects = {{"", random_triangles(300, 3)}};
  const groundtruth::RayProbe probe(scene);
  const auto path = folder_ / "deep.exr";
  write_deep(path, scene.width, scene.height,
             [&](int y) { return groundtruth::row_sums(scene, probe, y); });
  const auto file = OIIO::ImageInput::open(path.string());
  ASSERT_TRUE(file) << OIIO::geterror();
  ASSERT_TRUE(file->spec().deep);
  OIIO::DeepData data;
  ASSERT_TRUE(file->read_native_deep_image(0, 0, data));
  const auto& names = file->spec().channelnames;
  const auto channel = [&](const char* name) {
    return int(std::ranges::find(names, name) - names.begin());
  };
  const int red = channel("R"), alpha = channel("A"), depth = channel("Z");
  const int primitive = channel("primitive");
  const Image picture = raytraced(scene);
  int samples = 0;
  for (int pixel = 0; pixel < data.pixels(); ++pixel) {
    const groundtruth::RaySums ray = probe.at(pixel % scene.width + 0.5, pixel / scene.width + 0.5);
    ASSERT_EQ(data.samples(pixel), int(ray.layers.size()));
    double color = 0, shows = 1;
    for (int k = 0; k < data.samples(pixel); ++k, ++samples) {
      EXPECT_EQ(data.deep_value(pixel, depth, k), float(ray.layers[k].depth));
      EXPECT_EQ(data.deep_value_uint(pixel, primitive, k), ray.layers[k].primitive);
      color += shows * data.deep_value(pixel, red, k);
      shows *= 1 - data.deep_value(pixel, alpha, k);
    }
    color += shows * scene.background.r;
    // Each layer's α C and α are rounded to float, and so is the picture.
    const double tolerance = 1e-7 * (2 * data.samples(pixel) + 1);
    EXPECT_NEAR(color, picture.pixels[pixel].r, tolerance);
  }
  EXPECT_GT(samples, 300);
}

TEST_F(UnitSumsFile, RefusesAnotherEndingAndLeavesNothing) {
  const Raster<groundtruth::PixelSums> sums(2, 2);
  EXPECT_THROW(write_sums(folder_ / "sums.png", sums), InputError);
  EXPECT_THROW(write_sums(folder_ / "missing" / "sums.exr", sums), InputError);
  const auto interrupted = [](int y) -> std::vector<groundtruth::RaySums> {
    if (y == 1) throw WorkError("interrupted");
    return std::vector<groundtruth::RaySums>(2);
  };
  EXPECT_THROW(write_deep(folder_ / "deep.exr", 2, 2, interrupted), WorkError);
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
}

}  // namespace
}  // namespace pellucid::compare
