// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/parts/trace_deep.h"

#include "groundtruth/sums/picture_sums.h"

namespace pellucid::compare {

void trace_deep(const scene::Scene& scene, const groundtruth::RayProbe& probe,
                const std::function<void(int y, const DeepRow& row)>& take,
                const Progress& progress) {
  for (int y = 0; y < scene.height; ++y) {
    report(progress, double(y) / scene.height, "deep picture");
    take(y, deep_row(groundtruth::row_sums(scene, probe, y)));
  }
}

}  // namespace pellucid::compare
