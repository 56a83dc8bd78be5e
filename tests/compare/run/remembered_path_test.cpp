// SPDX-License-Identifier: GPL-3.0-or-later
// Studies along a camera path, on which methods keep something from frame to frame: the same
// pictures as render_sequence() makes.
#include <gtest/gtest.h>

#include "compare/methods/methods.h"
#include "compare/methods/optimize_opacities.h"
#include "compare/pictures/image_file.h"
#include "compare/run/frame_sequence.h"
#include "scene/files/scene_file.h"
#include "tests/compare/run/studies.h"

namespace pellucid::compare {
namespace {

using namespace pellucid::compare::testing;

constexpr std::size_t frames = 3;

class UnitRememberedPath : public ::testing::Test {
 protected:
  /// Discs, and behind them an important triangle that they come to stand beside.
  UnitRememberedPath() {
    write_text(folder_ / "discs.ply",
               "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
               "property float z\nend_header\n0.1 0.1 1\n0.3 0.1 1\n0.1 0.4 1.5\n");
    write_text(folder_ / "path.json",
               R"({"format": "pellucid-scene", "version": 1, "resolution": [24, 18],
                   "camera": {"type": "orthographic", "eye": [0, 0, 4], "up": [0, 1, 0],
                              "height": 2.4},
                   "camera_path": {"orbit": 60, "frames": )" +
                   std::to_string(frames) + R"(}, "energy": {"q": 50, "r": 100}, "objects": [
                     {"points": "discs.ply", "radius": 0.1, "opacity": 0.8, "color": "#ff0000"},
                     {"mesh": "triangle.ply", "importance": 1}]})");
  }

  StudyOutcome measure(const std::string& methods_and_more) {
    write_text(folder_ / "study.json",
               R"({"format": "pellucid-study", "version": 1, "scenes": ["path.json"],
                   "views": "path", "repeats": 1, "methods": )" +
                   methods_and_more + "}");
    StudyOptions options;
    options.folder = folder_ / "results";
    return run_study(load_study(folder_ / "study.json", methods()), options);
  }

  Image picture(const std::string& slug, std::size_t view) const {
    const std::string place = view > 0 ? ".view-" + std::to_string(view + 1) : "";
    return read_image(folder_ / "results/images/path" / (slug + place + ".exr"));
  }

  std::vector<Image> sequence(const std::string& method, const std::string& opacities = "") const {
    scene::Scene scene = scene::load_scene(folder_ / "path.json");
    std::vector<Image> pictures;
    render_sequence(scene, parse_call(method, methods()), parse_opacities(opacities), {},
                    [&](const SequenceFrame& frame) { pictures.push_back(frame.rendering.image); });
    return pictures;
  }

  StudyFolder folder_;
};

TEST_F(UnitRememberedPath, AMethodKeepsWhatItKeepsFromFrameToFrame) {
  measure(R"(["decoupled-lists:keep=0.8", "decoupled-lists"], "reference": "raytrace")");
  const std::vector<Image> kept = sequence("decoupled-lists:keep=0.8"),
                           forgotten = sequence("decoupled-lists");
  for (std::size_t i = 0; i < frames; ++i) {
    EXPECT_EQ(picture("decoupled-lists-keep-0.8", i).pixels, kept[i].pixels) << i;
    EXPECT_EQ(picture("decoupled-lists", i).pixels, forgotten[i].pixels) << i;
  }
  EXPECT_NE(kept.back().pixels, forgotten.back().pixels);
}

// Every cell follows the path from its beginning.
TEST_F(UnitRememberedPath, SoDoOpacitiesOfAStageOfTheirOwn) {
  measure(R"(["linked-list", "weighted-average"], "reference": "raytrace",
              "opacities": "decoupled-lists:keep=0.8")");
  for (const char* method : {"raytrace", "linked-list", "weighted-average"}) {
    const std::vector<Image> kept = sequence(method, "decoupled-lists:keep=0.8");
    for (std::size_t i = 0; i < frames; ++i)
      EXPECT_EQ(picture(method, i).pixels, kept[i].pixels) << method << ' ' << i;
  }
  EXPECT_NE(sequence("raytrace", "decoupled-lists:keep=0.8").back().pixels,
            sequence("raytrace", "decoupled-lists").back().pixels);
}

}  // namespace
}  // namespace pellucid::compare
