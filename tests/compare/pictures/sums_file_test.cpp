// SPDX-License-Identifier: GPL-3.0-or-later
// Exact sums in OpenEXR files: closed forms of stacks.

#include "compare/pictures/sums_file.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <map>
#include <span>

#include "core/error.h"
#include "readers/pictures/picture_file.h"
#include "tests/support/scenes.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::compare {
namespace {

using namespace testing;

/// A half of the picture is behind eight layers of α = 1/4, the other is empty.
scene::Scene half_a_stack(int samples) {
  scene::Scene scene = orthographic_scene(4, 2);
  scene.samples.per_axis = samples;
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
  write_sums(path, groundtruth::picture_sums(scene, groundtruth::RayProbe(scene), {}), {});
  const readers::PictureFile file = readers::read_picture_file(path);
  std::map<std::string, std::span<const float>> values;
  for (const Block& channel : file.channels) values[channel.name] = channel.values<float>();
  EXPECT_EQ(values.size(), 7);
  EXPECT_EQ(values["layers"][0], 8);
  EXPECT_EQ(values["coverage"][0], 1);
  EXPECT_EQ(values["far"][0], 5.75);
  EXPECT_EQ(values["near"][3], std::numeric_limits<float>::infinity());
  EXPECT_EQ(values["optical_depth"][3], 0);
  EXPECT_EQ(values["importance_sum"][0], 2);
  EXPECT_EQ(values["transmittance"][3], 1);
}

TEST_F(UnitSumsFile, RefusesAnotherEndingAndLeavesNothing) {
  const Raster<groundtruth::PixelSums> sums(2, 2);
  EXPECT_THROW(write_sums(folder_ / "sums.png", sums, {}), InputError);
  EXPECT_THROW(write_sums(folder_ / "missing" / "sums.exr", sums, {}), InputError);
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
}

}  // namespace
}  // namespace pellucid::compare
