// SPDX-License-Identifier: GPL-3.0-or-later
// Deep pictures of parts merge into the whole, to the last bit, whatever is in the scene; what is
// no set of parts is refused.

#include "compare/parts/merge.h"

#include <gmock/gmock.h>

#include <fmt/format.h>

#include <cmath>
#include <fstream>

#include "compare/parts/deep_outputs.h"
#include "compare/parts/trace_deep.h"
#include "compare/pictures/image_file.h"
#include "core/error.h"
#include "core/files/output_file.h"
#include "groundtruth/methods/raytrace.h"
#include "tests/support/part_scenes.h"
#include "tests/support/pictures.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::compare {
namespace {

using namespace testing;
using ::testing::AllOf;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

/// Writes deep pictures of a scene and of its parts.
class DeepFolder {
 public:
  fs::path write(const scene::Scene& scene, const scene::PartNumber& number,
                 const std::string& name) const {
    const groundtruth::ScenePart part = groundtruth::take_part(scene, number);
    DeepOutputs outputs(deep_info(scene, number, {fingerprint, "", false}), {}, folder_ / name);
    trace_deep(part.scene, groundtruth::RayProbe(part),
               [&](int y, const DeepRow& row) { outputs.take(y, row); }, {});
    outputs.commit();
    return folder_ / name;
  }
  std::vector<fs::path> write_parts(const scene::Scene& scene, int count) const {
    std::vector<fs::path> files;
    for (int part = count; part >= 1; --part)  // in any order
      files.push_back(write(scene, {part, count}, fmt::format("{}-{}.exr", scene.name, part)));
    return files;
  }
  /// The merged picture and deep picture lie in these files.
  fs::path picture() const { return folder_ / "picture.exr"; }
  fs::path deep() const { return folder_ / "merged.exr"; }

  void merge(const std::vector<fs::path>& files, std::uint64_t most_samples) const {
    const DeepParts parts(files);
    DeepOutputs outputs(parts.whole(), picture(), deep());
    parts.merge([&](int y, const DeepRow& row) { outputs.take(y, row); }, {}, most_samples);
    outputs.commit();
  }

  std::string fingerprint = "f";
  TemporaryFolder folder_;
};

void expect_merge_is_whole(const scene::Scene& scene, int parts, std::uint64_t most_samples) {
  const DeepFolder folder;
  folder.merge(folder.write_parts(scene, parts), most_samples);
  const Image exact = render(groundtruth::raytrace_method(), scene).image;
  EXPECT_EQ(read_image(folder.picture()).pixels, exact.pixels) << scene.name;
  const fs::path whole = folder.write(scene, {}, "whole.exr");
  EXPECT_EQ(read_text(folder.deep()), read_text(whole)) << scene.name;
}

TEST(PropertyMerge, PartsOfEveryKindMergeIntoTheWhole) {
  std::uint32_t seed = 0;
  for (const ScenesOfKind& kind : kinds_of_parts)
    expect_merge_is_whole(scene_of_kind(kind, ++seed), 3, std::uint64_t(1) << 20);
}

TEST(PropertyMerge, PartsOfAllKindsMergeIntoTheWhole) {
  for (const int parts : {1, 2, 7}) expect_merge_is_whole(scene_of_all_kinds(3), parts, 1 << 20);
}

TEST(PropertyMerge, FewRowsAtATimeAreTheSame) {
  expect_merge_is_whole(scene_of_all_kinds(2), 2, 3000);
  scene::Scene small = scene_of_all_kinds(2);
  small.height = 5;
  expect_merge_is_whole(small, 2, 0);  // a row at a time
}

TEST(UnitMerge, HoldsNoMoreRowsThanAsked) {
  const DeepFolder folder;
  const scene::Scene scene = stack(4, 6, {Rgba(0.5)});
  const DeepParts parts(folder.write_parts(scene, 2));
  // A row has 4 pixels of one layer.
  EXPECT_EQ(parts.end_of_rows(0, 8), 2);
  EXPECT_EQ(parts.end_of_rows(1, 11), 3);
  EXPECT_EQ(parts.end_of_rows(1, 12), 4);
  EXPECT_EQ(parts.end_of_rows(3, 0), 4);
  EXPECT_EQ(parts.end_of_rows(3, 1000), 6);
}

class UnitMergeRefuses : public ::testing::Test {
 protected:
  void SetUp() override {
    scene_.name = "scene";
    parts_ = folder_.write_parts(scene_, 3);
  }
  /// What is said of these files.
  static std::string refusal(const std::vector<fs::path>& files) {
    try {
      DeepParts(files).merge([](int, const DeepRow&) {}, {});
    } catch (const InputError& error) {
      return error.what();
    }
    return "nothing";
  }
  /// What is said when part 3 is of a scene that is changed so.
  template <class Change>
  std::string refusal_of_change(const Change& change) const {
    scene::Scene other = scene_;
    change(other);
    std::vector<fs::path> files = parts_;
    files[0] = folder_.write(other, {3, 3}, "other.exr");
    return refusal(files);
  }

  DeepFolder folder_;
  scene::Scene scene_ = stack(8, 8, {Rgba(0.5), Rgba(0.25), Rgba(0.75)});
  std::vector<fs::path> parts_;  // 3, 2, 1
};

TEST_F(UnitMergeRefuses, PartsOfDifferentPictures) {
  EXPECT_THAT(refusal_of_change([](scene::Scene& s) { s.camera.height = 3; }),
              AllOf(HasSubstr("its camera is"), HasSubstr("height=2"), HasSubstr("height=3")));
  EXPECT_THAT(refusal_of_change([](scene::Scene& s) { s.width = 9; }),
              AllOf(HasSubstr("its resolution is 8x8"), HasSubstr("9x8")));
  EXPECT_THAT(refusal_of_change([](scene::Scene& s) { s.background = Vec3(0); }),
              HasSubstr("its background is"));
  EXPECT_THAT(refusal_of_change([](scene::Scene& s) { s.name = "b"; }),
              HasSubstr("its scene is scene, of"));
  EXPECT_THAT(refusal_of_change([](scene::Scene& s) { s.objects[1].opaque = true; }),
              HasSubstr("opaque objects"));
  folder_.fingerprint = "g";
  EXPECT_THAT(refusal_of_change([](scene::Scene&) {}), HasSubstr("content of the scene is f"));
}

TEST_F(UnitMergeRefuses, PartsThatAreNotAllThereOnce) {
  EXPECT_THAT(refusal({parts_[0], parts_[2]}), HasSubstr("part 2 of 3 is missing"));
  EXPECT_THAT(refusal({parts_[0], parts_[1], parts_[1], parts_[2]}),
              AllOf(HasSubstr("scene-2.exr: is part 2 of 3, as"), HasSubstr("scene-2.exr is")));
  const fs::path of_two = folder_.write(scene_, {1, 2}, "of-two.exr");
  EXPECT_THAT(refusal({parts_[0], parts_[1], of_two}), HasSubstr("its number of parts is 2"));
}

TEST_F(UnitMergeRefuses, PartsOfAnotherBuild) {
  DeepInfo info = deep_info(scene_, {3, 3}, {"f", "", false});
  const std::unique_ptr<DeepWriter> rows = [&] {
    info.build = "another";
    return make_deep_writer(parts_[0], info);
  }();
  for (int y = 0; y < 8; ++y) rows->add({std::vector<std::uint32_t>(8, 0), {}});
  rows->commit();
  EXPECT_THAT(refusal(parts_), HasSubstr("its build is"));
}

TEST_F(UnitMergeRefuses, FilesThatAreCutOff) {
  const std::string whole = read_text(parts_[1]);
  for (const double share : {0.0, 0.3, 0.6, 0.9, 0.999}) {
    std::ofstream(parts_[1], std::ios::binary)
        << whole.substr(0, std::size_t(share * double(whole.size())));
    EXPECT_THAT(refusal(parts_), HasSubstr("scene-2.exr")) << share;
  }
}

TEST_F(UnitMergeRefuses, FilesThatAreNoDeepPictures) {
  write_image(folder_.folder_ / "flat.exr", Image(8, 8), {});
  EXPECT_THAT(refusal({folder_.folder_ / "flat.exr"}),
              HasSubstr("flat.exr: cannot read the picture: it is not deep"));
  write_image(folder_.folder_ / "flat.png", Image(8, 8), {});
  EXPECT_THAT(refusal({folder_.folder_ / "flat.png"}), HasSubstr("flat.png"));
  EXPECT_THAT(refusal({folder_.folder_ / "none.exr"}), HasSubstr("none.exr: cannot read"));
  folder_.write(scene_, {}, "whole.npz");
  EXPECT_THAT(refusal({folder_.folder_ / "whole.npz"}), HasSubstr("whole.npz"));
}

TEST_F(UnitMergeRefuses, ADepthThatIsNone) {
  const auto writer = make_deep_writer(parts_[0], deep_info(scene_, {3, 3}, {"f", "", false}));
  for (int y = 0; y < 8; ++y)
    writer->add(
        {std::vector<std::uint32_t>(8, 1), std::vector<DeepLayer>(8, DeepLayer{std::nan("")})});
  writer->commit();
  EXPECT_THAT(refusal(parts_), HasSubstr("scene-3.exr: is damaged: a view depth"));
}

}  // namespace
}  // namespace pellucid::compare
