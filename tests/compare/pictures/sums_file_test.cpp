// SPDX-License-Identifier: GPL-3.0-or-later
// Exact sums in OpenEXR files: closed forms of stacks, and deep samples that composite to the
// picture.

#include "compare/pictures/sums_file.h"

#include <OpenEXR/ImfDeepFrameBuffer.h>
#include <OpenEXR/ImfDeepScanLineInputFile.h>
#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <map>
#include <span>

#include "core/error.h"
#include "groundtruth/methods/raytrace.h"
#include "readers/pictures/picture_file.h"
#include "tests/support/pictures.h"
#include "tests/support/scenes.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::compare {
namespace {

using namespace testing;

Image raytraced(const scene::Scene& scene) {
  return render(groundtruth::raytrace_method(), scene).image;
}

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
  write_sums(path, groundtruth::picture_sums(scene, groundtruth::RayProbe(scene), {}));
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

/// A DeepFile is one channel of a deep picture: the samples of each pixel, 32 bits each.
class DeepFile {
 public:
  explicit DeepFile(const std::filesystem::path& path) : file_(path.c_str()) {}

  template <class T>
  std::vector<std::vector<T>> channel(const char* name) {
    constexpr Imf::PixelType type = std::is_integral_v<T> ? Imf::UINT : Imf::FLOAT;
    const Imath::Box2i box = file_.header().dataWindow();
    const int width = box.max.x + 1, height = box.max.y + 1;
    std::vector<unsigned> counts(std::size_t(width) * height);
    std::vector<T*> pointers(counts.size());
    Imf::DeepFrameBuffer frame;
    frame.insertSampleCountSlice(Imf::Slice(Imf::UINT, reinterpret_cast<char*>(counts.data()),
                                            sizeof(unsigned), sizeof(unsigned) * width));
    frame.insert(name, Imf::DeepSlice(type, reinterpret_cast<char*>(pointers.data()), sizeof(T*),
                                      sizeof(T*) * width, sizeof(T)));
    file_.setFrameBuffer(frame);
    file_.readPixelSampleCounts(0, height - 1);
    std::vector<std::vector<T>> samples;
    for (const unsigned count : counts) samples.emplace_back(count);
    for (std::size_t i = 0; i < samples.size(); ++i) pointers[i] = samples[i].data();
    file_.readPixels(0, height - 1);
    return samples;
  }

 private:
  Imf::DeepScanLineInputFile file_;
};

TEST_F(UnitSumsFile, DeepSamplesCompositeToThePicture) {
  scene::Scene scene;
  scene.width = 17;
  scene.height = 9;
  scene.objects = {{"", random_triangles(300, 3)}};
  const groundtruth::RayProbe probe(scene);
  const auto path = folder_ / "deep.exr";
  write_deep(path, scene.width, scene.height,
             [&](int y) { return groundtruth::row_sums(scene, probe, y); });
  DeepFile file(path);
  const auto red = file.channel<float>("R"), alpha = file.channel<float>("A"),
             depth = file.channel<float>("Z");
  const auto primitive = file.channel<std::uint32_t>("primitive");
  const Image picture = raytraced(scene);
  int samples = 0;
  for (std::size_t pixel = 0; pixel < picture.pixels.size(); ++pixel) {
    const auto x = int(pixel) % scene.width, y = int(pixel) / scene.width;
    const groundtruth::RaySums ray = probe.at(x + 0.5, y + 0.5);
    ASSERT_EQ(red[pixel].size(), ray.layers.size());
    double color = 0, shows = 1;
    for (std::size_t k = 0; k < ray.layers.size(); ++k, ++samples) {
      EXPECT_EQ(depth[pixel][k], float(ray.layers[k].depth));
      EXPECT_EQ(primitive[pixel][k], ray.layers[k].primitive);
      color += shows * red[pixel][k];
      shows *= 1 - alpha[pixel][k];
    }
    color += shows * scene.background.r;
    // Each layer's α C and α are rounded to float, and so is the picture.
    const double tolerance = 1e-7 * (2 * double(ray.layers.size()) + 1);
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
