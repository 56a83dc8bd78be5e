// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "compare/results/result_row.h"
#include "compare/study/study.h"

namespace pellucid::compare {

/// A SceneSize is how large a scene is as far as its file tells without drawing it.
struct SceneSize {
  double pixels = 0;      // of a picture
  double samples = 1;     // of a pixel
  double views = 1;       // from which a study sees it
  double bytes_read = 0;  // of the scene's file and the files that it names
};

/// Returns the size of a scene, seen from the study's views. Throws InputError when the file is no
/// JSON.
SceneSize scene_size(const std::filesystem::path& scene_file, const Views& views);

/// A CellEstimate is what computing a cell may take.
struct CellEstimate {
  double seconds = 0;  // wall clock, from the program's start to its end
  double bytes = 0;    // of memory at once
};

/// Estimates a cell from the size of its scene and, where there is one, a known row of it or of
/// another cell of its scene; else by a rule of thumb, whose ground and error docs/cluster.md has.
CellEstimate estimate_cell(const SceneSize& size, const TimingRule& timing, const ResultRow* known);

}  // namespace pellucid::compare
