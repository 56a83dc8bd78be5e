// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "compare/run/study_jobs.h"
#include "scene/elements/frame_memory.h"

namespace pellucid::compare {

/// A Finding is what was found of a cell from the views until now, or why it failed: an adverse
/// cell must not take the others with it.
struct Finding {
  ViewRows rows;
  std::string error = {};
  scene::FrameMemory memory = {};  // of what the method keeps along a camera path
};

/// A BatchMeter measures cells of one scene in turn, batch after batch, and tells how the machine
/// was meanwhile.
class BatchMeter {
 public:
  /// Calibrates the machine. Study and options have to outlive the meter.
  BatchMeter(const Study& study, const StudyOptions& options);

  /// Measures the cells of the batch in turn, from view after view those that have not failed yet,
  /// and writes their pictures. Along a camera path a method keeps from view to view what it keeps
  /// from frame to frame.
  std::vector<Finding> measure(const std::vector<Job*>& batch, SceneAtHand& at_hand);

  /// Returns the row of a cell of the last batch.
  ResultRow row_of(const Job& job, const Finding& finding, SceneAtHand& at_hand) const;

 private:
  void measure_view(const std::vector<Job*>& batch, SceneAtHand& at_hand, const std::string& place,
                    std::vector<Finding>& findings);
  void finish_one(const Job& job, MeasuredCell measured, SceneAtHand& at_hand,
                  const std::string& place, Finding& finding);
  void calibrate_in_turn(std::size_t cells);

  const Study& study_;
  const StudyOptions& options_;
  std::vector<Calibration> calibrations_;  // from the last batch's end on
};

}  // namespace pellucid::compare
