// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/cells/cell.h"
#include "compare/changes/past_run.h"
#include "compare/pictures/image_file.h"
#include "tests/compare/study/result_rows.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::compare::testing {

/// A picture whose pixels all differ, so that a wrong place shows.
inline Image ramp(int width, int height, float blue) {
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      image.at(x, y) = Rgba(float(x) / float(width), float(y) / float(height), blue, 1);
  return image;
}

/// Results in a folder of their own: scenes "a" (40 × 20 pixels) and "b" (20 × 20); the reference
/// "truth", "near" and "far", of growing error and sinking time.
class FigureRun {
 public:
  FigureRun() {
    run_.folder = folder_.path();
    run_.study = "study";
    for (const char* scene : {"a", "b"}) {
      add(scene, "truth", 0, 0.25f, 0.3);
      add(scene, "near", 0.01, 0.26f, 0.2);
      add(scene, "far", 0.25, 0.5f, 0.1);
    }
  }

  PastRun& run() { return run_; }
  std::filesystem::path file(const std::string& name) const { return folder_ / name; }
  std::filesystem::path picture(std::size_t row) const {
    return CellFiles(run_.folder, run_.rows[row]).picture();
  }

 private:
  void add(const std::string& scene, const std::string& method, double rmse, float blue,
           double seconds) {
    run_.rows.push_back(row(scene, method, rmse));
    ResultRow& added = run_.rows.back();
    added.reference = method == "truth";
    added.seconds.median = seconds;
    added.bytes = {{"list", 2000000}};
    const CellFiles files(run_.folder, added);
    files.make_folders();
    write_image(files.picture(), ramp(scene == "a" ? 40 : 20, 20, blue), {});
  }

  pellucid::testing::TemporaryFolder folder_;
  PastRun run_;
};

}  // namespace pellucid::compare::testing
