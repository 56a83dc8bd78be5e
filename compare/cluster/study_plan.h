// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "compare/cluster/cell_estimate.h"
#include "compare/run/run_study.h"

namespace pellucid::compare {

/// A PlannedCell is what is known of a cell before it is computed.
struct PlannedCell {
  std::string cell;                // "SCENE/METHOD:PARAMETERS", as compute_cell() takes it
  std::vector<std::string> needs;  // cells that have to be there before it
  std::string scene;
  std::string scene_file;
  SceneSize size;  // of its scene
  CellEstimate estimate;
  bool timed = true;  // its times count, so that nothing may run beside it
  bool done = false;  // it is there, finished without an error by this build: who resumes keeps it
};

/// Plans the cells of a study in its order, in which a cell comes after those that it needs: the
/// reference of its scene. Estimates come from the rows in the folder where there are some; nothing
/// is drawn, loaded or written. Not timed are pictures from elsewhere and the cells of a study that
/// draws each picture once. Throws as load_study() and scene_size() do.
std::vector<PlannedCell> plan_study(const Study& study, const StudyOptions& options);

/// Returns a line of JSON: cell, needs, scene, scene_file, pixels (of all views), bytes_read,
/// seconds, bytes, timed, done.
std::string plan_line(const PlannedCell& planned);

}  // namespace pellucid::compare
