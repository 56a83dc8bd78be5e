// SPDX-License-Identifier: GPL-3.0-or-later
// Deep pictures as files: what other programs read of them.

#include "compare/deep/deep_writer.h"

#include <OpenEXR/ImfDeepFrameBuffer.h>
#include <OpenEXR/ImfDeepScanLineInputFile.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <gmock/gmock.h>
#include <sys/resource.h>

#include <csignal>
#include <cstdlib>
#include <fstream>

#include "compare/parts/deep_outputs.h"
#include "compare/parts/trace_deep.h"
#include "core/error.h"
#include "core/files/output_file.h"
#include "groundtruth/methods/raytrace.h"
#include "tests/support/part_scenes.h"
#include "tests/support/pictures.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::compare {
namespace {

using namespace testing;
using ::testing::HasSubstr;

class UnitDeepWriter : public ::testing::Test {
 protected:
  static void write(const scene::Scene& scene, const groundtruth::RayProbe& probe,
                    const std::filesystem::path& path) {
    DeepOutputs outputs(deep_info(scene, {}, {"f", "", false}), {}, path);
    trace_deep(scene, probe, [&](int y, const DeepRow& row) { outputs.take(y, row); }, {});
    outputs.commit();
  }

  TemporaryFolder folder_;
};

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

TEST_F(UnitDeepWriter, PlainSamplesCompositeToThePicture) {
  scene::Scene scene;
  scene.width = 17;
  scene.height = 9;
  scene.objects = {{"", random_triangles(300, 3)}};
  const groundtruth::RayProbe probe(scene);
  const auto path = folder_ / "deep.exr";
  write(scene, probe, path);
  DeepFile file(path);
  const auto red = file.channel<float>("R"), alpha = file.channel<float>("A"),
             depth = file.channel<float>("Z");
  const auto primitive = file.channel<std::uint32_t>("primitive");
  const Image picture = testing::render(groundtruth::raytrace_method(), scene).image;
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

TEST_F(UnitDeepWriter, ExrSaysWhatItIsOf) {
  const scene::Scene scene = scene_of_kind(kinds_of_parts[6], 0);
  write(scene, groundtruth::RayProbe(scene), folder_ / "deep.exr");
  const Imf::DeepScanLineInputFile file((folder_ / "deep.exr").c_str());
  const auto* text = file.header().findTypedAttribute<Imf::StringAttribute>("pellucid");
  ASSERT_NE(text, nullptr);
  const DeepInfo info = deep_info_of("deep.exr", text->value());
  EXPECT_EQ(info, deep_info(scene, {}, {"f", "", false}));
  EXPECT_EQ(info.opaque, (std::vector<int>{0, 1}));
  EXPECT_EQ(info.background, scene.background);
}

// By NumPy, as the documents say; exact values of a stack in closed form.
TEST_F(UnitDeepWriter, NumPyReadsNpz) {
  scene::Scene scene = stack(3, 2, {Rgba(1, 0.5, 0, 0.25f), Rgba(0, 0.5, 1, 0.5f)});
  scene.objects[1].vertices().importance.assign(4, 0.5f);
  write(scene, groundtruth::RayProbe(scene), folder_ / "deep.npz");
  std::ofstream(folder_ / "read.py") << R"(
import json, numpy as np, sys
deep = np.load(sys.argv[1])
assert sorted(deep.files) == ["color", "depth", "importance", "info", "object", "offsets", "opacity",
                              "primitive", "shape"]
assert deep["shape"].tolist() == [2, 3]
assert deep["offsets"].dtype == np.uint64 and deep["offsets"].tolist() == list(range(0, 14, 2))
assert deep["depth"].dtype == np.float64 and deep["depth"].tolist() == [4, 6] * 6
assert deep["opacity"].tolist() == [0.25, 0.5] * 6
assert deep["color"].shape == (12, 3) and deep["color"][:2].tolist() == [[1, 0.5, 0], [0, 0.5, 1]]
assert deep["importance"].dtype == np.float32 and deep["importance"].tolist() == [0, 0.5] * 6
assert deep["object"].dtype == np.uint32 and deep["object"].tolist() == [0, 1] * 6
assert set(deep["primitive"].tolist()) <= {0, 1}
info = json.loads(deep["info"].item())
assert info["format"] == "pellucid-deep" and info["part"] == [1, 1], info
)";
  const std::string command =
      "/usr/bin/python3 " + (folder_ / "read.py").string() + ' ' + (folder_ / "deep.npz").string();
  EXPECT_EQ(std::system(command.c_str()), 0);
}

TEST_F(UnitDeepWriter, EqualPicturesAreEqualFiles) {
  const scene::Scene scene = scene_of_all_kinds(1);
  const groundtruth::RayProbe probe(scene);
  for (const char* ending : {".exr", ".npz"}) {
    const auto one = folder_ / (std::string("one") + ending),
               two = folder_ / (std::string("two") + ending);
    write(scene, probe, one);
    write(scene, probe, two);
    EXPECT_EQ(read_text(one), read_text(two)) << ending;
  }
}

TEST_F(UnitDeepWriter, LeavesNothingWithoutCommit) {
  DeepInfo info;
  info.width = info.height = 2;
  EXPECT_THROW(make_deep_writer(folder_ / "deep.png", info), InputError);
  EXPECT_THROW(make_deep_writer(folder_ / "missing" / "deep.exr", info), InputError);
  EXPECT_THROW(make_deep_writer(folder_ / "missing" / "deep.npz", info), InputError);
  for (const char* name : {"deep.exr", "deep.npz"})
    make_deep_writer(folder_ / name, info)->add({{1, 0}, {DeepLayer{1}}});
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
}

/// Files of this process take no more than so many bytes, as on a full disk.
class FullDisk {
 public:
  explicit FullDisk(std::uint64_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  void (*handler_)(int);
  rlimit before_;
};

TEST_F(UnitDeepWriter, AFullDiskIsAnErrorAndLeavesNothing) {
  const scene::Scene scene = scene_of_all_kinds(1);
  const groundtruth::RayProbe probe(scene);
  for (const char* name : {"deep.exr", "deep.npz"})
    for (const std::uint64_t bytes : {1000, 20000, 60000}) {
      const FullDisk full(bytes);
      // What a limit of the process and a full disk say are different errors of the system.
      EXPECT_THROW(write(scene, probe, folder_ / name), std::runtime_error) << name << bytes;
      EXPECT_TRUE(std::filesystem::is_empty(folder_.path())) << name << bytes;
    }
}

}  // namespace
}  // namespace pellucid::compare
